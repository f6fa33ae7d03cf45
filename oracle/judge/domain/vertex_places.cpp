#include "oracle/judge/domain/vertex_places.hpp"

#include <algorithm>
#include <array>

#include "kernel/boxes/box_index.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/domain/measures.hpp"

namespace circumspect::check {

namespace {

// A long segment that runs aslant has a box that holds much of the mesh, its pieces have not.
constexpr int kPieces = 32;
// The first radius is this many doublings below the last.
constexpr int kDoublings = 24;
constexpr int kDoublingsAtOnce = 2;

Rational power_of_two(int exponent) {
  Rational power = 1;
  for (int i = 0; i < exponent; ++i) power *= 2;
  return power;
}

Rational product(const Point& a, const Point& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// A box around all points no further along any axis than `radius` from a point.
Box box_of_radius(const Point& centre, const Rational& radius) {
  Box box = box_around(centre);
  for (std::size_t corner = 0; corner < std::size_t{1} << centre.size(); ++corner) {
    Point at = centre;
    for (std::size_t i = 0; i < at.size(); ++i) {
      at[i] += (corner >> i) % 2 == 0 ? radius : Rational(-radius);
    }
    box = box_around(box, box_around(at));
  }
  return box;
}

}  // namespace

// A point, or a segment in pieces.
struct VertexSearch::Target {
  std::vector<Point> points;
  bool is_point() const { return points.size() == 1; }

  Rational squared_distance_to(const Point& p) const {
    const Point& a = points.front();
    if (is_point()) return squared_distance(a, p);
    const Point along = points.back() - a;
    const Rational t = product(p - a, along) / squared_length(along);
    if (t <= 0) return squared_distance(a, p);
    if (t >= 1) return squared_distance(points.back(), p);
    Point foot = a;
    for (std::size_t i = 0; i < foot.size(); ++i) foot[i] += t * along[i];
    return squared_distance(foot, p);
  }

  // Boxes that hold every point within a distance of it.
  std::vector<Box> boxes_around(const Rational& radius) const {
    std::vector<Box> ends;
    for (const Point& point : points) ends.push_back(box_of_radius(point, radius));
    if (is_point()) return ends;
    std::vector<Box> pieces;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      pieces.push_back(box_around(ends[i], ends[i + 1]));
    }
    return pieces;
  }
};

std::optional<NearestVertex> VertexSearch::to_point(const Point& point) {
  return nearest_to({{point}});
}

std::optional<NearestVertex> VertexSearch::to_segment(const Point& a, const Point& b) {
  Target target{{a}};
  for (int i = 1; i < kPieces; ++i) {
    const Rational t = Rational(i) / kPieces;
    Point at = a;
    for (std::size_t axis = 0; axis < at.size(); ++axis) at[axis] += t * (b[axis] - a[axis]);
    target.points.push_back(at);
  }
  target.points.push_back(b);
  return nearest_to(target);
}

void VertexSearch::make_index() {
  std::vector<Box> boxes;
  for (Vertex v = 0; mesh_.points.names(v); ++v) {
    if (!used_[static_cast<std::size_t>(v)]) continue;
    const Point& point = mesh_.points[v];
    if (indexed_.empty()) low_ = high_ = point;
    for (std::size_t i = 0; i < point.size(); ++i) {
      low_[i] = std::min(low_[i], point[i]);
      high_[i] = std::max(high_[i], point[i]);
    }
    boxes.push_back(box_around(point));
    indexed_.push_back(v);
  }
  index_ = std::make_unique<const BoxIndex>(boxes);
}

// The vertex in some boxes that is nearest to the target, but not on it if that is a segment.
std::optional<NearestVertex> VertexSearch::best_of(const Target& target,
                                                   const std::vector<Box>& boxes) {
  std::vector<std::size_t> places;
  for (const Box& box : boxes) {
    const std::vector<std::size_t> more = index_->meeting(box);
    places.insert(places.end(), more.begin(), more.end());
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::optional<NearestVertex> best;
  for (const std::size_t place : places) {
    if (++looked_at_ > kMostLookedAt) return std::nullopt;
    const Vertex v = indexed_[place];
    Rational squared = target.squared_distance_to(mesh_.points[v]);
    if (squared == 0 && !target.is_point()) continue;
    if (!best || squared < best->squared_distance) best = {v, std::move(squared)};
  }
  return best;
}

// In growing neighbourhoods: what is found within one's radius cannot be beaten outside it.
std::optional<NearestVertex> VertexSearch::nearest_to(const Target& target) {
  if (index_ == nullptr) make_index();
  if (indexed_.empty()) return std::nullopt;
  // No vertex is further than this from the target along any axis, nor twice this in all.
  Rational furthest = 0;
  for (const Point& end : {target.points.front(), target.points.back()}) {
    for (std::size_t i = 0; i < end.size(); ++i) {
      furthest = std::max({furthest, Rational(abs(Rational(end[i] - low_[i]))),
                           Rational(abs(Rational(end[i] - high_[i])))});
    }
  }
  Rational radius = 2 * furthest / power_of_two(kDoublings);
  for (int doubled = 0; doubled <= kDoublings; doubled += kDoublingsAtOnce) {
    const auto best = best_of(target, target.boxes_around(radius));
    if (looked_at_ > kMostLookedAt) return std::nullopt;
    if (best && best->squared_distance <= radius * radius) return best;
    radius *= power_of_two(kDoublingsAtOnce);
  }
  return std::nullopt;
}

// ---- Vertex places ----

namespace {

std::vector<Vertex> lexicographic_order(const PointSet& points) {
  std::vector<Vertex> order(points.size());
  for (Vertex v = 0; points.names(v); ++v) order[points.configuration().rank(v)] = v;
  return order;
}

void mark_used(const std::vector<Simplex>& simplices, std::vector<bool>& used) {
  for (const Simplex& simplex : simplices) {
    for (const Vertex v : simplex) used[VertexPlaces::place(v)] = true;
  }
}

// Around each cell of which the corners are given.
BoxIndex index_of(const std::vector<Box>& boxes_of_points, const std::vector<Simplex>& cells) {
  std::vector<Box> boxes;
  boxes.reserve(cells.size());
  for (const Simplex& corners : cells) {
    Box box = boxes_of_points[VertexPlaces::place(corners.front())];
    for (const Vertex v : corners) box = box_around(box, boxes_of_points[VertexPlaces::place(v)]);
    boxes.push_back(box);
  }
  return BoxIndex(boxes);
}

Simplex renumbered(Simplex simplex, const std::vector<Vertex>& number) {
  for (Vertex& v : simplex) v = number[VertexPlaces::place(v)];
  return simplex;
}

// The triangles of all polygons, by the points of the mesh.
struct Triangles {
  std::vector<Simplex> corners;
  std::vector<std::size_t> polygon;
};

Triangles triangles_of(const PiecewiseLinearComplex& complex, const std::vector<Vertex>& in_mesh) {
  Triangles triangles;
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    for (const Simplex& triangle : complex.polygons[p].triangles) {
      triangles.corners.push_back(renumbered(triangle, in_mesh));
      triangles.polygon.push_back(p);
    }
  }
  return triangles;
}

}  // namespace

VertexPlaces match_vertices(const ExactMesh& mesh, const PiecewiseLinearComplex& complex) {
  VertexPlaces places;
  const std::size_t size = mesh.points.size();
  places.in_mesh.assign(complex.points.size(), kNoVertex);
  places.in_domain.assign(size, kNoVertex);
  places.used.assign(size, false);
  places.segment.assign(size, kNowhere);
  places.polygon.assign(size, kNowhere);
  mark_used(mesh.simplices, places.used);
  mark_used(mesh.faces, places.used);
  const std::vector<Vertex> ours = lexicographic_order(complex.points);
  const std::vector<Vertex> theirs = lexicographic_order(mesh.points);
  auto candidate = theirs.begin();
  for (const Vertex v : ours) {
    const Point& point = complex.points[v];
    while (candidate != theirs.end() && mesh.points[*candidate] < point) ++candidate;
    if (candidate == theirs.end()) break;
    if (mesh.points[*candidate] != point) continue;
    places.in_mesh[VertexPlaces::place(v)] = *candidate;
    places.in_domain[VertexPlaces::place(*candidate)] = v;
  }
  return places;
}

void locate_steiner_points(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                           VertexPlaces& places) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.points.size());
  for (const Point& point : mesh.points.points()) boxes.push_back(box_around(point));
  std::vector<Simplex> segments;
  segments.reserve(complex.segments.size());
  for (const Simplex& segment : complex.segments) {
    segments.push_back(renumbered(segment, places.in_mesh));
  }
  const BoxIndex segment_index = index_of(boxes, segments);
  const Triangles triangles = triangles_of(complex, places.in_mesh);
  const BoxIndex index = index_of(boxes, triangles.corners);
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (!places.is_steiner(v)) continue;
    const Box& box = boxes[VertexPlaces::place(v)];
    std::size_t& on_segment = places.segment[VertexPlaces::place(v)];
    for (const std::size_t s : segment_index.meeting(box)) {
      if (lies_inside_segment(mesh.points.configuration(), segments[s], v)) on_segment = s;
    }
    if (on_segment != kNowhere) continue;
    for (const std::size_t t : index.meeting(box)) {
      const std::size_t p = triangles.polygon[t];
      if (!lies_in(mesh.points.configuration(), complex.polygons[p].axes, triangles.corners[t],
                   v)) {
        continue;
      }
      places.polygon[VertexPlaces::place(v)] = p;
      break;
    }
  }
}

SteinerPoints count_steiner_points(const VertexPlaces& places) {
  SteinerPoints count;
  for (std::size_t v = 0; v < places.in_domain.size(); ++v) {
    if (!places.is_steiner(static_cast<Vertex>(v))) continue;
    if (places.segment[v] != kNowhere) {
      ++count.on_segments;
    } else if (places.polygon[v] != kNowhere) {
      ++count.in_polygons;
    } else {
      ++count.in_polyhedra;
    }
  }
  return count;
}

bool judge_vertices(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                    const VertexPlaces& places, bool steiner_points_allowed, VertexSearch& search,
                    Verdict& verdict) {
  bool complete = true;
  for (Vertex v = 0; complex.points.names(v); ++v) {
    if (places.in_mesh[VertexPlaces::place(v)] != kNoVertex) continue;
    complete = false;
    Witness witness{.point = complex.points[v], .domain_cell = Simplex{v}};
    if (verdict.keeps_more()) witness.nearest = search.to_point(complex.points[v]);
    verdict.add(Rule::kDomainVertexMissing, witness);
  }
  ExtraVertices extra;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const std::size_t place = VertexPlaces::place(v);
    if (places.in_domain[place] != kNoVertex) continue;
    if (!places.used[place]) {
      verdict.add(Rule::kUnusedPoint, {.vertices = {v}, .point = mesh.points[v]});
      continue;
    }
    extra.add(v, verdict.max_violations());
    if (!steiner_points_allowed) verdict.add(Rule::kSteinerForbidden, {.vertices = {v}});
  }
  verdict.extra_vertices = std::move(extra);
  return complete;
}

}  // namespace circumspect::check
