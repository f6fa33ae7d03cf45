#include "oracle/judge/fast/triangle_complex.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "kernel/exact/each_once.hpp"
#include "oracle/judge/fast/box_tree.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {
namespace {

using Corners = std::array<std::int32_t, 3>;

// The positions of points of a list with respect to one another, by exact signs.
class Points {
 public:
  explicit Points(std::span<const double> coordinates)
      : coordinates_(coordinates), lattice_(lattice_of_all(coordinates, {})) {}

  Site<3> operator[](std::int32_t v) const {
    const std::size_t at = 3 * static_cast<std::size_t>(v);
    return {{coordinates_[at], coordinates_[at + 1], coordinates_[at + 2]}};
  }
  int side(const Corners& plane, std::int32_t v) const {
    return turn(plane[0], plane[1], plane[2], v);
  }
  int turn(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const {
    return orientation((*this)[a], (*this)[b], (*this)[c], (*this)[d], stages_, lattice_);
  }
  int turn(PlaneAxes axes, std::int32_t a, std::int32_t b, std::int32_t c) const {
    return orientation(projected(axes, a), projected(axes, b), projected(axes, c), stages_,
                       lattice_);
  }

 private:
  Site<2> projected(PlaneAxes axes, std::int32_t v) const {
    const std::size_t at = 3 * static_cast<std::size_t>(v);
    return {{coordinates_[at + axes.x], coordinates_[at + axes.y]}};
  }

  std::span<const double> coordinates_;
  Lattice lattice_;
  mutable Stages stages_;
};

PlaneAxes axes_of(const Points& points, const Corners& t) {
  for (const PlaneAxes axes : {PlaneAxes{0, 1}, PlaneAxes{0, 2}, PlaneAxes{1, 2}}) {
    if (points.turn(axes, t[0], t[1], t[2]) != 0) return axes;
  }
  return {};
}

// A triangle, or one of its segments, against others of the same plane.
class InPlane {
 public:
  InPlane(const Points& points, const Corners& triangle)
      : points_(points), triangle_(triangle), axes_(axes_of(points, triangle)) {
    front_ = turn(triangle[0], triangle[1], triangle[2]);
  }

  int turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
    return points_.turn(axes_, a, b, c);
  }

  // Does the line of an edge of the triangle have all these points strictly beyond it?
  template <std::size_t kCount>
  bool an_edge_separates(const std::array<std::int32_t, kCount>& others) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t p = triangle_[i], q = triangle_[(i + 1) % 3];
      const auto is_beyond = [&](std::int32_t v) { return turn(p, q, v) == -front_; };
      if (std::all_of(others.begin(), others.end(), is_beyond)) return true;
    }
    return false;
  }
  // Does the line of a segment have all of the triangle strictly on one side?
  bool is_beside(std::int32_t p, std::int32_t q) const {
    const int side = turn(p, q, triangle_[0]);
    return side != 0 && turn(p, q, triangle_[1]) == side && turn(p, q, triangle_[2]) == side;
  }
  // Is the direction from the apex, a corner of the triangle, to v in the closed angle of the
  // triangle there?
  bool has_in_angle(std::int32_t apex, std::int32_t v) const {
    const std::size_t at = apex == triangle_[0] ? 0 : apex == triangle_[1] ? 1 : 2;
    return turn(apex, triangle_[(at + 1) % 3], v) != -front_ &&
           turn(apex, v, triangle_[(at + 2) % 3]) != -front_;
  }

 private:
  const Points& points_;
  const Corners& triangle_;
  PlaneAxes axes_;
  int front_ = 0;
};

// Does a segment meet a triangle? Requires: its ends lie strictly on different sides of the
// triangle's plane.
bool pierces(const Points& points, std::int32_t p, std::int32_t q, const Corners& triangle) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int turn = points.turn(p, q, triangle[i], triangle[(i + 1) % 3]);
    left |= turn > 0;
    right |= turn < 0;
  }
  return !(left && right);
}

// The sides of a plane on which the corners of a triangle are.
std::array<int, 3> sides_of(const Points& points, const Corners& plane, const Corners& triangle) {
  return {points.side(plane, triangle[0]), points.side(plane, triangle[1]),
          points.side(plane, triangle[2])};
}
bool are_strictly_on_one_side(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

// Does an edge of a triangle meet another triangle, given the sides of the other's plane on which
// the corners are?
bool an_edge_meets(const Points& points, const Corners& triangle, const std::array<int, 3>& sides,
                   const Corners& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::int32_t p = triangle[i], q = triangle[j];
    if (sides[i] * sides[j] > 0) continue;
    if (sides[i] * sides[j] < 0) {
      if (pierces(points, p, q, other)) return true;
      continue;
    }
    const InPlane plane(points, other);
    if (sides[i] == 0 && sides[j] == 0) {
      if (!plane.an_edge_separates(std::array{p, q}) && !plane.is_beside(p, q)) return true;
    } else if (!plane.an_edge_separates(std::array{sides[i] == 0 ? p : q})) {
      return true;
    }
  }
  return false;
}

// Are two triangles without a common vertex disjoint? If they are not, and lie in different planes,
// an edge of one meets the other. If they are coplanar and disjoint, one triangle has an edge whose
// line has the other triangle strictly beyond it: the Minkowski difference of the two is a polygon
// without the origin, and each of its edges is parallel to one of theirs.
bool are_apart(const Points& points, const Corners& a, const Corners& b) {
  const std::array<int, 3> of_b = sides_of(points, a, b);
  if (are_strictly_on_one_side(of_b)) return true;
  if (of_b == std::array{0, 0, 0}) {
    return InPlane(points, a).an_edge_separates(b) || InPlane(points, b).an_edge_separates(a);
  }
  const std::array<int, 3> of_a = sides_of(points, b, a);
  if (are_strictly_on_one_side(of_a)) return true;
  return !an_edge_meets(points, b, of_b, a) && !an_edge_meets(points, a, of_a, b);
}

// The corners of a triangle without one of them, in rotary order.
std::array<std::int32_t, 2> others(const Corners& triangle, std::int32_t corner) {
  const std::size_t at = corner == triangle[0] ? 0 : corner == triangle[1] ? 1 : 2;
  return {triangle[(at + 1) % 3], triangle[(at + 2) % 3]};
}

// Do two triangles with one common vertex meet only there? Their intersection is convex, so
// anything else in it is connected to the vertex. If they are coplanar, it is more than the vertex
// iff a side of one angle is in the other angle. In two planes it is a segment from the vertex,
// which ends where an edge opposite the vertex meets the other triangle, or is part of an edge at
// the vertex.
bool meet_in_vertex(const Points& points, const Corners& a, const Corners& b, std::int32_t v) {
  const auto of_a = others(a, v), of_b = others(b, v);
  const int b0 = points.side(a, of_b[0]), b1 = points.side(a, of_b[1]);
  if (b0 * b1 > 0) return true;
  if (b0 == 0 && b1 == 0) {
    const InPlane at_a(points, a), at_b(points, b);
    return !at_a.has_in_angle(v, of_b[0]) && !at_a.has_in_angle(v, of_b[1]) &&
           !at_b.has_in_angle(v, of_a[0]) && !at_b.has_in_angle(v, of_a[1]);
  }
  if (b0 == 0 || b1 == 0) return !InPlane(points, a).has_in_angle(v, b0 == 0 ? of_b[0] : of_b[1]);
  const int a0 = points.side(b, of_a[0]), a1 = points.side(b, of_a[1]);
  if (a0 * a1 > 0) return true;
  if (a0 == 0 || a1 == 0) return !InPlane(points, b).has_in_angle(v, a0 == 0 ? of_a[0] : of_a[1]);
  return !pierces(points, of_b[0], of_b[1], a) && !pierces(points, of_a[0], of_a[1], b);
}

// Do two triangles with two common vertices and different third vertices meet only in the edge
// between the two?
bool meet_in_edge(const Points& points, const Corners& a, std::int32_t apex_a,
                  std::int32_t apex_b) {
  if (points.side(a, apex_b) != 0) return true;
  const auto edge = others(a, apex_a);
  const InPlane plane(points, a);
  return plane.turn(edge[0], edge[1], apex_a) == -plane.turn(edge[0], edge[1], apex_b);
}

bool meet_properly(const Points& points, const Corners& a, const Corners& b) {
  std::array<std::int32_t, 3> common = {};
  std::size_t count = 0;
  std::int32_t apex_b = 0, apex_a = 0;
  for (const std::int32_t v : b) {
    const bool is_common = v == a[0] || v == a[1] || v == a[2];
    if (is_common) common[count++] = v;
    if (!is_common) apex_b = v;
  }
  if (count == 0) return are_apart(points, a, b);
  if (count == 1) return meet_in_vertex(points, a, b, common[0]);
  if (count == 3) return false;
  for (const std::int32_t v : a) {
    if (v != common[0] && v != common[1]) apex_a = v;
  }
  return meet_in_edge(points, a, apex_a, apex_b);
}

std::vector<AxisBox> boxes_of(std::span<const double> coordinates,
                              std::span<const Corners> triangles) {
  std::vector<AxisBox> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& corners : triangles) {
    AxisBox box = box_of_point(coordinates, static_cast<std::size_t>(corners[0]));
    box.add(box_of_point(coordinates, static_cast<std::size_t>(corners[1])));
    box.add(box_of_point(coordinates, static_cast<std::size_t>(corners[2])));
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

PlaneAxes axes_of_triangle(std::span<const double> coordinates, const Corners& triangle) {
  std::array<double, 9> corners;
  for (std::size_t i = 0; i < 9; ++i) {
    corners[i] = coordinates[3 * static_cast<std::size_t>(triangle[i / 3]) + i % 3];
  }
  return axes_of(Points(corners), {0, 1, 2});
}

namespace {

// Calls visit(a, b) for every two triangles that do not meet as they should, until it returns
// false; false then, and if that would take long, or a triangle has its corners on a line.
template <class Visit>
bool visit_improper(std::span<const double> coordinates, std::span<const Corners> triangles,
                    const Visit& visit) {
  constexpr std::size_t kSteps = 32;  // for each triangle, on average
  const Points points(coordinates);
  for (const Corners& triangle : triangles) {
    if (axes_of(points, triangle).none()) return false;
  }
  return BoxTree(boxes_of(coordinates, triangles))
      .all_pairs(kSteps * triangles.size() + kSteps, [&](std::uint32_t a, std::uint32_t b) {
        return meet_properly(points, triangles[a], triangles[b]) || visit(a, b);
      });
}

}  // namespace

bool are_surely_a_complex(std::span<const double> coordinates, std::span<const Corners> triangles) {
  return visit_improper(coordinates, triangles, [](std::size_t, std::size_t) { return false; });
}

std::optional<std::vector<std::size_t>> improper_triangles(std::span<const double> coordinates,
                                                           std::span<const Corners> triangles) {
  std::vector<std::size_t> found;
  const bool are_all = visit_improper(coordinates, triangles, [&](std::size_t a, std::size_t b) {
    found.insert(found.end(), {a, b});
    return true;
  });
  if (!are_all) return std::nullopt;
  keep_each_once(found);
  return found;
}

}  // namespace circumspect::fast
