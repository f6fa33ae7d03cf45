#include "oracle/judge/within/nearly_coplanar.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "kernel/boxes/box_index.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/within/cells.hpp"
#include "oracle/judge/within/distance.hpp"

namespace circumspect::check {
namespace {

// How much farther than its own height other cells have to be from a polygon that is not flat, and
// how much if vertices are to move as far as they may in a complex of flat ones.
constexpr long kTimesFarther = 8;
constexpr long kTimesFarthest = 100;
// The square of the tangent of 5 degrees, rounded up: no polygon is steeper upon the plane of all.
const Rational kSquaredSteepest(77, 10'000);

struct Plane {
  Point origin;
  Point u;  // in it
  Point normal;

  Rational height_times_length(const Point& point) const {
    return inner_product(normal, point - origin);
  }
};

Plane plane_of(const PointSet& points, const Simplex& triangle) {
  const Point& origin = points[triangle[0]];
  Point u = points[triangle[1]] - origin;
  Point normal = cross_product(u, points[triangle[2]] - origin);
  return {origin, std::move(u), std::move(normal)};
}

// Is the square of the tangent of the angle between them at most that?
bool are_at_most(const Rational& squared_slope, const Plane& a, const Plane& b) {
  const Rational along = inner_product(a.normal, b.normal);
  return squared_length(cross_product(a.normal, b.normal)) <= squared_slope * along * along;
}

class NearlyCoplanar {
 public:
  NearlyCoplanar(const PiecewiseLinearComplex& complex, const std::vector<Simplex>& listed,
                 const Flatness& flatness)
      : complex_(complex), flatness_(flatness), set_(complex.polygons.size(), kNone) {
    for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
      planes_.push_back(plane_of(complex.points, complex.polygons[p].triangles.front()));
      for (const Simplex& segment : complex.polygons[p].segments) at_[segment].push_back(p);
    }
    std::erase_if(at_, [&](const auto& one) {
      return one.second.size() != 2 || std::binary_search(listed.begin(), listed.end(), one.first);
    });
    const Cells cells(complex);
    for (const Cell cell : cells.all()) {
      for (Simplex& simplex : cells.simplices(cell)) pieces_.push_back(std::move(simplex));
    }
    index_.emplace(CellBoxes(complex.points).of(pieces_));
  }

  NearlyJoined result() {
    for (const std::size_t seed : largest_first()) {
      if (set_[seed] == kNone) grow(seed);
    }
    NearlyJoined joined{complex_, {}, 0, squared_height_, refused_, squared_limit_};
    joined.complex.polygons.clear();
    std::set<Simplex> removed;
    for (const auto& [segment, polygons] : at_) {
      if (set_[polygons[0]] == set_[polygons[1]]) removed.insert(segment);
    }
    joined.removed_segments = removed.size();
    std::erase_if(joined.complex.segments, [&](const Simplex& s) { return removed.contains(s); });
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t p = 0; p < set_.size(); ++p) members[set_[p]].push_back(p);
    std::vector<std::pair<std::size_t, std::size_t>> order;  // first member, seed
    for (const auto& [seed, of_seed] : members) order.emplace_back(of_seed.front(), seed);
    std::sort(order.begin(), order.end());
    for (const auto& [first, seed] : order) {
      joined.complex.polygons.push_back(joined_polygon(seed, members[seed], removed));
      joined.members.push_back(members[seed]);
    }
    return joined;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::vector<std::size_t> largest_first() const {
    std::vector<std::pair<Rational, std::size_t>> order;
    for (std::size_t p = 0; p < complex_.polygons.size(); ++p) {
      // Along one axis, areas of one plane are to each other as they are.
      Rational area = 0;
      const Point& normal = planes_[p].normal;
      for (const Simplex& triangle : complex_.polygons[p].triangles) {
        area += abs(inner_product(normal, plane_of(complex_.points, triangle).normal));
      }
      order.emplace_back(-area * area / squared_length(normal), p);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> places;
    for (const auto& [area, place] : order) places.push_back(place);
    return places;
  }

  bool is_flat_enough(std::size_t polygon, const Plane& plane) const {
    if (!are_at_most(kSquaredSteepest, planes_[polygon], plane)) return false;
    const Rational limit = flatness_.squared_distance * squared_length(plane.normal);
    const std::vector<Vertex>& vertices = complex_.polygons[polygon].vertices;
    return std::all_of(vertices.begin(), vertices.end(), [&](Vertex v) {
      const Rational height = plane.height_times_length(complex_.points[v]);
      return height * height <= limit;
    });
  }

  void grow(std::size_t seed) {
    const Plane& plane = planes_[seed];
    std::vector<std::size_t> members = {seed};
    set_[seed] = seed;
    for (std::size_t next = 0; next < members.size(); ++next) {
      for (const Simplex& segment : complex_.polygons[members[next]].segments) {
        const auto at = at_.find(segment);
        if (at == at_.end()) continue;
        for (const std::size_t other : at->second) {
          if (set_[other] != kNone) continue;
          const Plane& beside = planes_[members[next]];
          if (!are_at_most(flatness_.squared_slope, beside, planes_[other])) continue;
          if (!is_flat_enough(other, plane)) continue;
          set_[other] = seed;
          members.push_back(other);
        }
      }
    }
    if (members.size() == 1) return;
    Rational highest = 0;
    std::vector<Simplex> triangles;
    for (const std::size_t p : members) {
      const Polygon& polygon = complex_.polygons[p];
      triangles.insert(triangles.end(), polygon.triangles.begin(), polygon.triangles.end());
      for (const Vertex v : polygon.vertices) {
        highest = std::max(highest, Rational(abs(plane.height_times_length(complex_.points[v]))));
      }
    }
    const Rational squared_height = highest * highest / squared_length(plane.normal);
    std::optional<Rational> apart;
    const bool is_beside = are_beside_each_other(triangles, plane);
    if (is_beside) apart = squared_distance_to_others(triangles, squared_height);
    if (!is_beside || (apart && *apart <= kTimesFarther * kTimesFarther * squared_height)) {
      ++refused_;
      for (const std::size_t p : members) set_[p] = kNone;
      set_[seed] = seed;
      return;
    }
    squared_height_ = std::max(squared_height_, squared_height);
    if (!apart) return;
    const Rational limit = *apart / 32;
    if (!squared_limit_ || limit < *squared_limit_) squared_limit_ = limit;
  }

  // Are no two triangles before each other, seen along the normal?
  bool are_beside_each_other(const std::vector<Simplex>& triangles, const Plane& plane) const {
    const Point w = cross_product(plane.normal, plane.u);
    std::map<Vertex, Vertex> place;
    std::vector<Point> flat;
    std::vector<Simplex> flat_triangles;
    for (const Simplex& triangle : triangles) {
      Simplex corners;
      for (const Vertex v : triangle) {
        const auto [at, is_new] = place.try_emplace(v, static_cast<Vertex>(flat.size()));
        if (is_new) {
          const Point to = complex_.points[v] - plane.origin;
          flat.push_back({inner_product(to, plane.u), inner_product(to, w)});
        }
        corners.push_back(at->second);
      }
      flat_triangles.push_back(std::move(corners));
    }
    if (!duplicates(flat).empty()) return false;
    const PointSet points(std::move(flat));
    const CellBoxes boxes(points);
    const BoxIndex index = boxes.index_of(flat_triangles);
    const std::vector<std::size_t> axes = {0, 1};
    for (std::size_t i = 0; i < flat_triangles.size(); ++i) {
      for (const std::size_t j : index.meeting(boxes.of(flat_triangles[i]))) {
        if (j <= i) continue;
        if (interiors_meet(points.configuration(), axes, flat_triangles[i], flat_triangles[j])) {
          return false;
        }
      }
    }
    return true;
  }

  // How far the next cell without a vertex in common is, unless it is farther than others ever have
  // to be.
  std::optional<Rational> squared_distance_to_others(const std::vector<Simplex>& triangles,
                                                     const Rational& squared_height) const {
    const Rational squared_far = kTimesFarthest * kTimesFarthest * squared_height;
    const Rational far = upper_square_root(squared_far);
    std::set<Vertex> own;
    for (const Simplex& triangle : triangles) own.insert(triangle.begin(), triangle.end());
    std::optional<Rational> least;
    for (const Simplex& triangle : triangles) {
      const std::vector<Point> corners = coordinates(complex_.points, triangle);
      Box box = cube(corners[0], far);
      for (const Point& corner : corners) box = box_around(box, cube(corner, far));
      for (const std::size_t piece : index_->meeting(box)) {
        const Simplex& other = pieces_[piece];
        if (std::any_of(other.begin(), other.end(), [&](Vertex v) { return own.contains(v); })) {
          continue;
        }
        const auto apart = squared_distance_between(corners, coordinates(complex_.points, other));
        if (apart <= squared_far && (!least || apart < *least)) least = apart;
      }
    }
    return least;
  }

  Polygon joined_polygon(std::size_t seed, const std::vector<std::size_t>& members,
                         const std::set<Simplex>& removed) const {
    Polygon polygon = complex_.polygons[seed];
    if (members.size() == 1) return polygon;
    polygon.hole_seeds.clear();
    for (const std::size_t p : members) {
      if (p == seed) continue;
      const Polygon& member = complex_.polygons[p];
      polygon.vertices.insert(polygon.vertices.end(), member.vertices.begin(),
                              member.vertices.end());
      polygon.segments.insert(polygon.segments.end(), member.segments.begin(),
                              member.segments.end());
      polygon.triangles.insert(polygon.triangles.end(), member.triangles.begin(),
                               member.triangles.end());
    }
    std::erase_if(polygon.segments, [&](const Simplex& s) { return removed.contains(s); });
    // The triangles stay in this order: the first of them says which plane is that of the polygon.
    keep_each_once(polygon.segments);
    keep_each_once(polygon.vertices);
    return polygon;
  }

  const PiecewiseLinearComplex& complex_;
  const Flatness& flatness_;
  std::vector<Plane> planes_;
  std::vector<std::size_t> set_;                    // by its seed
  std::map<Simplex, std::vector<std::size_t>> at_;  // segments across which polygons may be joined
  std::vector<Simplex> pieces_;
  std::optional<BoxIndex> index_;
  Rational squared_height_ = 0;
  std::size_t refused_ = 0;
  std::optional<Rational> squared_limit_;
};

}  // namespace

NearlyJoined nearly_coplanar_polygons_joined(const PiecewiseLinearComplex& complex,
                                             const std::vector<Simplex>& listed,
                                             const Flatness& flatness) {
  return NearlyCoplanar(complex, listed, flatness).result();
}

StayingSegments::StayingSegments(const PiecewiseLinearComplex& complex, Rational squared_slope)
    : complex_(complex),
      squared_slope_(std::move(squared_slope)),
      at_vertex_(complex.points.size()) {
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    for (const Vertex v : complex.polygons[p].vertices) {
      at_vertex_[static_cast<std::size_t>(v)].push_back(p);
    }
  }
}

std::vector<std::size_t> StayingSegments::at(const Simplex& segment) const {
  std::vector<std::size_t> found;
  for (const std::size_t p : at_vertex_[static_cast<std::size_t>(segment[0])]) {
    const std::vector<Simplex>& segments = complex_.polygons[p].segments;
    if (std::find(segments.begin(), segments.end(), segment) != segments.end()) found.push_back(p);
  }
  return found;
}

bool StayingSegments::certainly(const Simplex& segment) const {
  constexpr std::size_t kMostPolygons = 100;
  const auto plane = [&](std::size_t p) {
    return plane_of(complex_.points, complex_.polygons[p].triangles.front());
  };
  const std::vector<std::size_t> own = at(segment);
  if (own.size() != 2) return own.size() < 2;
  std::vector<std::size_t> reached = {own[0]};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    if (reached[next] == own[1] || reached.size() > kMostPolygons) return false;
    const Plane here = plane(reached[next]);
    for (const Simplex& across : complex_.polygons[reached[next]].segments) {
      for (const std::size_t other : at(across)) {
        if (std::find(reached.begin(), reached.end(), other) != reached.end()) continue;
        if (are_at_most(squared_slope_, here, plane(other))) reached.push_back(other);
      }
    }
  }
  return true;
}

}  // namespace circumspect::check
