#include "kernel/predicates/place.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "kernel/predicates/orientation.hpp"

namespace circumspect {

namespace {

bool has(std::span<const Vertex> simplex, Vertex v) {
  return std::find(simplex.begin(), simplex.end(), v) != simplex.end();
}

// Does v have no barycentric sign below `lowest`? Most simplices are not around v: the first such
// sign answers.
bool has_no_sign_below(int lowest, const Configuration& points, std::span<const std::size_t> axes,
                       std::span<const Vertex> simplex, Vertex v) {
  const int own = orientation(points, axes, simplex);
  assert(own != 0);
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    if (own * orientation_with(points, axes, simplex, place, v) < lowest) return false;
  }
  return true;
}

using Axes = std::array<std::size_t, 2>;
constexpr std::array<Axes, 3> kCoordinatePlanes = {Axes{0, 1}, Axes{0, 2}, Axes{1, 2}};

// The coordinate planes; in the plane there is only the first.
std::span<const Axes> coordinate_planes(const Configuration& points) {
  return std::span(kCoordinatePlanes).first(points.ambient_dimension() == 2 ? 1 : 3);
}

// Does an edge of `a` have all of `b` on its outer side or in its line?
bool an_edge_separates(const Configuration& points, std::span<const std::size_t> axes,
                       std::span<const Vertex> a, std::span<const Vertex> b) {
  const int front = orientation(points, axes, a);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex p = a[i], q = a[(i + 1) % 3];
    const bool separates = std::none_of(b.begin(), b.end(), [&](Vertex v) {
      return v != p && v != q && orientation(points, axes, std::array{p, q, v}) == front;
    });
    if (separates) return true;
  }
  return false;
}

}  // namespace

int barycentric_sign(const Configuration& points, std::span<const std::size_t> axes,
                     std::span<const Vertex> simplex, std::size_t place, Vertex v) {
  const int own = orientation(points, axes, simplex);
  assert(own != 0);
  return own * orientation_with(points, axes, simplex, place, v);
}

int barycentric_sign(const Configuration& points, std::span<const Vertex> simplex,
                     std::size_t place, Vertex v) {
  return barycentric_sign(points, points.axes(), simplex, place, v);
}

int barycentric_sign(const Configuration& points, std::span<const Vertex> simplex, int own,
                     std::size_t place, Vertex v) {
  assert(own != 0);
  return own * orientation_with(points, points.axes(), simplex, place, v);
}

std::vector<int> barycentric_signs(const Configuration& points, std::span<const std::size_t> axes,
                                   std::span<const Vertex> simplex, Vertex v) {
  const int own = orientation(points, axes, simplex);
  assert(own != 0);
  std::vector<int> signs;
  signs.reserve(simplex.size());
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    signs.push_back(own * orientation_with(points, axes, simplex, place, v));
  }
  return signs;
}

std::vector<int> barycentric_signs(const Configuration& points, std::span<const Vertex> simplex,
                                   Vertex v) {
  return barycentric_signs(points, points.axes(), simplex, v);
}

bool lies_in(const Configuration& points, std::span<const std::size_t> axes,
             std::span<const Vertex> simplex, Vertex v) {
  return has(simplex, v) || (is_in_hull_of(points, axes, simplex, v) &&
                             has_no_sign_below(0, points, axes, simplex, v));
}

bool lies_inside(const Configuration& points, std::span<const std::size_t> axes,
                 std::span<const Vertex> simplex, Vertex v) {
  return is_in_hull_of(points, axes, simplex, v) && has_no_sign_below(1, points, axes, simplex, v);
}

// The hull is the graph of affine functions over the axes: v is on it iff it is on the graph of
// each of these functions, seen on the axes and the coordinate of its values.
bool is_in_hull_of(const Configuration& points, std::span<const std::size_t> axes,
                   std::span<const Vertex> simplex, Vertex v) {
  std::vector<std::size_t> with_another(axes.begin(), axes.end());
  with_another.push_back(0);
  std::vector<Vertex> with_v(simplex.begin(), simplex.end());
  with_v.push_back(v);
  for (std::size_t axis = 0; axis < points.ambient_dimension(); ++axis) {
    if (std::find(axes.begin(), axes.end(), axis) != axes.end()) continue;
    with_another.back() = axis;
    if (orientation(points, with_another, with_v) != 0) return false;
  }
  return true;
}

bool lies_in(const Configuration& points, std::span<const Vertex> simplex, Vertex v) {
  if (has(simplex, v)) return true;
  if (simplex.size() == 2) return lies_inside_segment(points, simplex, v);
  return lies_in(points, axes_of(points, simplex), simplex, v);
}

bool lies_inside(const Configuration& points, std::span<const Vertex> simplex, Vertex v) {
  if (simplex.size() == 1) return simplex[0] == v;
  if (has(simplex, v)) return false;
  if (simplex.size() == 2) return lies_inside_segment(points, simplex, v);
  return lies_inside(points, axes_of(points, simplex), simplex, v);
}

bool lies_inside_segment(const Configuration& points, std::span<const Vertex> segment, Vertex v) {
  // On the line the lexicographic order is the order along it.
  const auto [low, high] = std::minmax({points.rank(segment[0]), points.rank(segment[1])});
  if (points.rank(v) <= low || high <= points.rank(v)) return false;
  if (points.ambient_dimension() < 2 || points.ambient_dimension() > 3) {
    return is_in_hull_of(points, axes_of(points, segment), segment, v);
  }
  return std::all_of(coordinate_planes(points).begin(), coordinate_planes(points).end(),
                     [&](const Axes& axes) {
                       return orientation(points, axes, std::array{segment[0], segment[1], v}) == 0;
                     });
}

bool segments_cross(const Configuration& points, std::span<const Vertex> a,
                    std::span<const Vertex> b) {
  if (points.ambient_dimension() == 3 &&
      orientation(points, kSpace, std::array{a[0], a[1], b[0], b[1]}) != 0) {
    return false;
  }
  // Four coplanar points. Unless their plane is perpendicular to a coordinate plane, in which case
  // all signs are zero there, the projection preserves the answer.
  for (const Axes& axes : coordinate_planes(points)) {
    const int b0 = orientation(points, axes, std::array{a[0], a[1], b[0]});
    const int b1 = orientation(points, axes, std::array{a[0], a[1], b[1]});
    if (b0 * b1 > 0) return false;
    const int a0 = orientation(points, axes, std::array{b[0], b[1], a[0]});
    const int a1 = orientation(points, axes, std::array{b[0], b[1], a[1]});
    if (a0 * a1 > 0) return false;
    if (b0 != 0 || b1 != 0 || a0 != 0 || a1 != 0) return b0 * b1 < 0 && a0 * a1 < 0;
  }
  return false;
}

std::vector<std::size_t> axes_of_plane(const Configuration& points,
                                       std::span<const Vertex> triangle) {
  for (const Axes& axes : coordinate_planes(points)) {
    if (orientation(points, axes, triangle) != 0) return {axes.begin(), axes.end()};
  }
  return {};
}

int side_of_triangle(const Configuration& points, std::span<const Vertex> triangle, Vertex v) {
  if (has(triangle, v)) return 0;
  return orientation(points, kSpace, std::array{triangle[0], triangle[1], triangle[2], v});
}

bool segment_pierces_triangle(const Configuration& points, std::span<const Vertex> segment,
                              std::span<const Vertex> triangle) {
  const int side = side_of_triangle(points, triangle, segment[0]);
  if (side == 0 || side_of_triangle(points, triangle, segment[1]) != -side) return false;
  bool left = false, right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int turn = orientation(
        points, kSpace, std::array{segment[0], segment[1], triangle[i], triangle[(i + 1) % 3]});
    left = left || turn > 0;
    right = right || turn < 0;
    if (left && right) return false;
  }
  return true;
}

bool interiors_meet(const Configuration& points, std::span<const std::size_t> axes,
                    std::span<const Vertex> a, std::span<const Vertex> b) {
  // Two convex polygons of a plane have disjoint interiors iff the line of an edge separates them.
  return !an_edge_separates(points, axes, a, b) && !an_edge_separates(points, axes, b, a);
}

}  // namespace circumspect
