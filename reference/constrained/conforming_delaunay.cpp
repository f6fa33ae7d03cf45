#include "reference/constrained/conforming_delaunay.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "kernel/complex/circumball.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/steiner_cdt.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::constrained {

namespace {

Rational turn(const std::vector<std::size_t>& axes, const Point& a, const Point& b,
              const Point& c) {
  return cross_product(b - a, c - a, axes[0], axes[1]);
}

bool is_in_triangle(const std::vector<std::size_t>& axes, const std::vector<Point>& corners,
                    const Point& point) {
  int least = 1;
  int greatest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = sign(turn(axes, corners[i], corners[(i + 1) % 3], point));
    least = std::min(least, side);
    greatest = std::max(greatest, side);
  }
  return least >= 0 || greatest <= 0;
}

// The nearest multiple of the step; only multiples are allowed.
Rational rounded(const Rational& value, const Rational& step) {
  const Rational half_up = value / step + Rational(1, 2);
  Integer floor;
  floor = half_up.get_num() / half_up.get_den();
  if (sign(half_up) < 0 && floor * half_up.get_den() != half_up.get_num()) floor -= 1;
  return floor * step;
}

// Vectors of the plane of three points with coordinates (1, 0) and (0, 1) on the axes.
std::vector<Point> unit_steps(const std::vector<std::size_t>& axes,
                              const std::vector<Point>& corners) {
  const Point u = corners[1] - corners[0];
  const Point v = corners[2] - corners[0];
  const std::size_t x = axes[0];
  const std::size_t y = axes[1];
  const Rational determinant = cross_product(u, v, x, y);
  assert(sign(determinant) != 0);
  return {(v[y] / determinant) * u - (u[y] / determinant) * v,
          (u[x] / determinant) * v - (v[x] / determinant) * u};
}

}  // namespace

std::vector<Simplex> subfacets(const PointSet& points, const Polygon& polygon,
                               const std::vector<Vertex>& vertices) {
  const PointSet own(coordinates(points, vertices));
  const delaunay::BowyerWatsonOptions options{delaunay::InsertionOrder::kBrioHilbert,
                                              delaunay::PointLocation::kWalking, 1};
  const Triangulation canonical = delaunay::bowyer_watson(own, options);
  std::vector<Simplex> inside;
  for (Simplex triangle : canonical.simplices()) {
    if (!is_in_polygon(points, polygon, barycentre(own, triangle))) continue;
    for (Vertex& v : triangle) v = vertices[static_cast<std::size_t>(v)];
    inside.push_back(sorted(triangle));
  }
  return inside;
}

bool is_in_polygon(const PointSet& points, const Polygon& polygon, const Point& point) {
  return std::any_of(polygon.triangles.begin(), polygon.triangles.end(),
                     [&](const Simplex& triangle) {
                       return is_in_triangle(polygon.axes, coordinates(points, triangle), point);
                     });
}

// With a step h on the axes, the point moves by at most h/2 along each of the unit steps e and f.
// In all, that is at most a quarter of the radius if h² · 2 (|e|² + |f|²) ≤ r²/4.
Point near_circumcentre(const PointSet& points, const Polygon& polygon, const Ball& circumball) {
  const std::vector<Point> units =
      unit_steps(polygon.axes, coordinates(points, polygon.triangles.front()));
  const Rational bound =
      circumball.squared_radius / (8 * (squared_length(units[0]) + squared_length(units[1])));
  Rational step = 1;
  while (step * step > bound) step /= 2;
  while (4 * step * step <= bound) step *= 2;
  Point near = circumball.centre;
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational& here = circumball.centre[polygon.axes[i]];
    near = near + (rounded(here, step) - here) * units[i];
  }
  return near;
}

bool do_meet(const std::vector<std::size_t>& axes, const Point& a, const Point& b, const Point& c,
             const Point& d) {
  return sign(turn(axes, a, b, c)) * sign(turn(axes, a, b, d)) <= 0 &&
         sign(turn(axes, c, d, a)) * sign(turn(axes, c, d, b)) <= 0;
}

namespace {

// A point that may be added to a polygon, and the subfacet's smallest circumball.
struct Candidate {
  Point point;
  Rational squared_radius;
};

class Refinement {
 public:
  Refinement(const PiecewiseLinearComplex& complex, std::size_t most_steiner_points)
      : complex_(complex),
        most_steiner_points_(most_steiner_points),
        segments_(complex),
        points_(complex.points),
        polygons_of_segment_(complex.segments.size()) {
    std::map<Simplex, std::size_t> place_of;
    for (std::size_t i = 0; i < complex.segments.size(); ++i) place_of[complex.segments[i]] = i;
    for (std::size_t i = 0; i < complex.polygons.size(); ++i) {
      vertices_.push_back(complex.polygons[i].vertices);
      for (const Simplex& segment : complex.polygons[i].segments) {
        polygons_of_segment_[place_of.at(segment)].push_back(i);
      }
    }
  }

  tl::expected<ConformingDelaunay, SteinerLimitReached> run() {
    while (true) {
      const StarIndex canonical = canonical_delaunay(points_);
      fresh_points_ = points_.points();
      refine(canonical);
      if (fresh_points_.size() == points_.size()) break;
      if (fresh_points_.size() > complex_.points.size() + most_steiner_points_) {
        return tl::unexpected(SteinerLimitReached{segments_.added().size(), in_polygons_.size()});
      }
      points_ = PointSet(std::move(fresh_points_));
    }
    PiecewiseLinearComplex augmented = segments_.augmented(points_, in_polygons_);
    // Its cells are unions of Delaunay simplices. So its CDT is part of the Delaunay triangulation.
    PlcTriangulation triangulation = cdt_of_edge_protected(augmented);
    return ConformingDelaunay{std::move(augmented), std::move(triangulation), segments_.added(),
                              std::move(in_polygons_)};
  }

 private:
  void refine(const StarIndex& canonical) {
    const auto added = points_for_unprotected_subsegments(points_, canonical, segments_,
                                                          SubsegmentCondition::kInCanonical);
    for (const PointOnSegment& point : added) add(point);
    if (!added.empty()) return;
    std::set<Simplex> to_split;
    for (std::size_t i = 0; i < complex_.polygons.size(); ++i) refine(canonical, i, to_split);
    for (const Subsegment& subsegment : segments_.subsegments()) {
      if (!to_split.contains(subsegment.edge)) continue;
      add({static_cast<Vertex>(fresh_points_.size()), subsegment.segment,
           segments_.where_to_split(subsegment)});
    }
  }

  void add(const PointOnSegment& point) {
    fresh_points_.push_back(segments_.point_at(point.segment, point.parameter));
    segments_.add(point);
    for (const std::size_t i : polygons_of_segment_[point.segment]) {
      vertices_[i].push_back(point.vertex);
    }
  }

  // Does what a single polygon needs.
  void refine(const StarIndex& canonical, std::size_t i, std::set<Simplex>& to_split) {
    const Polygon& polygon = complex_.polygons[i];
    std::vector<Simplex> missing = subfacets(points_, polygon, vertices_[i]);
    std::erase_if(missing, [&](const Simplex& facet) { return !canonical.star(facet).empty(); });
    if (missing.empty()) return;
    const std::vector<Simplex> subsegments = subsegments_of(i);
    std::vector<Simplex> encroached = subsegments;
    std::erase_if(encroached, [&](const Simplex& subsegment) {
      return has_empty_diametral_ball(points_, canonical, subsegment);
    });
    to_split.insert(encroached.begin(), encroached.end());
    if (!encroached.empty()) return;
    std::vector<Candidate> accepted;
    for (const Simplex& subfacet : missing) {
      const Ball ball = circumball(points_, subfacet);
      Candidate candidate{near_circumcentre(points_, polygon, ball), ball.squared_radius};
      const std::vector<Simplex> in_the_way =
          subsegments_in_the_way(polygon, subsegments, subfacet, candidate);
      to_split.insert(in_the_way.begin(), in_the_way.end());
      if (in_the_way.empty() && keeps_its_distance(candidate, accepted)) {
        accepted.push_back(std::move(candidate));
      }
    }
    for (Candidate& candidate : accepted) {
      const auto vertex = static_cast<Vertex>(fresh_points_.size());
      fresh_points_.push_back(std::move(candidate.point));
      vertices_[i].push_back(vertex);
      in_polygons_.push_back({vertex, i});
    }
  }

  std::vector<Simplex> subsegments_of(std::size_t i) const {
    std::vector<Simplex> own;
    for (const Subsegment& subsegment : segments_.subsegments()) {
      const std::vector<std::size_t>& polygons = polygons_of_segment_[subsegment.segment];
      if (std::find(polygons.begin(), polygons.end(), i) != polygons.end()) {
        own.push_back(subsegment.edge);
      }
    }
    return own;
  }

  // The subsegments whose closed diametral balls contain the point; if there are none and it is
  // outside the polygon, one that is between it and the subfacet.
  std::vector<Simplex> subsegments_in_the_way(const Polygon& polygon,
                                              const std::vector<Simplex>& subsegments,
                                              const Simplex& subfacet,
                                              const Candidate& candidate) const {
    std::vector<Simplex> in_the_way;
    for (const Simplex& subsegment : subsegments) {
      if (sign(inner_product(points_[subsegment[0]] - candidate.point,
                             points_[subsegment[1]] - candidate.point)) <= 0) {
        in_the_way.push_back(subsegment);
      }
    }
    if (!in_the_way.empty() || is_in_polygon(points_, polygon, candidate.point)) return in_the_way;
    const Point middle = barycentre(points_, subfacet);
    const auto between =
        std::find_if(subsegments.begin(), subsegments.end(), [&](const Simplex& subsegment) {
          return do_meet(polygon.axes, middle, candidate.point, points_[subsegment[0]],
                         points_[subsegment[1]]);
        });
    assert(between != subsegments.end());  // The boundary is a union of them.
    return {*between};
  }

  static bool keeps_its_distance(const Candidate& candidate,
                                 const std::vector<Candidate>& accepted) {
    return std::all_of(accepted.begin(), accepted.end(), [&](const Candidate& other) {
      return 4 * squared_distance(candidate.point, other.point) >
             std::max(candidate.squared_radius, other.squared_radius);
    });
  }

  const PiecewiseLinearComplex& complex_;
  std::size_t most_steiner_points_;
  SplitSegments segments_;
  PointSet points_;
  std::vector<Point> fresh_points_;  // the points and those that this round adds
  std::vector<PointInPolygon> in_polygons_;
  std::vector<std::vector<Vertex>> vertices_;  // by polygon
  std::vector<std::vector<std::size_t>> polygons_of_segment_;
};

}  // namespace

tl::expected<ConformingDelaunay, SteinerLimitReached> conforming_delaunay(
    const PiecewiseLinearComplex& complex, std::size_t most_steiner_points) {
  return Refinement(complex, most_steiner_points).run();
}

}  // namespace circumspect::constrained
