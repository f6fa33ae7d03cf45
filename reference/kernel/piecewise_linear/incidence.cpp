#include "reference/kernel/piecewise_linear/incidence.hpp"

#include <algorithm>
#include <array>

#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect {
namespace {

using Axes = std::array<std::size_t, 2>;
constexpr std::array<Axes, 3> kCoordinatePlanes = {{{0, 1}, {0, 2}, {1, 2}}};

// The coordinate planes; in the plane there is only the first.
std::span<const Axes> coordinate_planes(const Configuration& points) {
  return std::span(kCoordinatePlanes).first(points.ambient_dimension() == 2 ? 1 : 3);
}

// Does an edge of `a` have all of `b` on its other side, or in its line?
bool an_edge_separates(const Configuration& points, std::span<const std::size_t> axes,
                       const Simplex& a, const Simplex& b) {
  const int front = orientation(points, axes, a);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex p = a[i], q = a[(i + 1) % 3];
    const bool separates = std::none_of(b.begin(), b.end(), [&](Vertex v) {
      return v != p && v != q && orientation(points, axes, Simplex{p, q, v}) == front;
    });
    if (separates) return true;
  }
  return false;
}

}  // namespace

bool lies_inside_segment(const Configuration& points, Vertex v, const Simplex& segment) {
  for (const Axes& axes : coordinate_planes(points)) {
    if (orientation(points, axes, Simplex{segment[0], segment[1], v}) != 0) return false;
  }
  // On the line the lexicographic order is the order along it.
  const auto [low, high] = std::minmax({points.rank(segment[0]), points.rank(segment[1])});
  return low < points.rank(v) && points.rank(v) < high;
}

bool segments_cross(const Configuration& points, const Simplex& a, const Simplex& b) {
  if (points.ambient_dimension() == 3 &&
      orientation(points, kSpace, Simplex{a[0], a[1], b[0], b[1]}) != 0) {
    return false;
  }
  // Four points of one plane. Unless it is upright over a coordinate plane, in which case all signs
  // are zero there, the projection keeps what there is to decide.
  for (const Axes& axes : coordinate_planes(points)) {
    const int b0 = orientation(points, axes, Simplex{a[0], a[1], b[0]});
    const int b1 = orientation(points, axes, Simplex{a[0], a[1], b[1]});
    if (b0 * b1 > 0) return false;
    const int a0 = orientation(points, axes, Simplex{b[0], b[1], a[0]});
    const int a1 = orientation(points, axes, Simplex{b[0], b[1], a[1]});
    if (a0 * a1 > 0) return false;
    if (b0 != 0 || b1 != 0 || a0 != 0 || a1 != 0) return b0 * b1 < 0 && a0 * a1 < 0;
  }
  return false;
}

std::vector<std::size_t> axes_of_plane(const Configuration& points, const Simplex& triangle) {
  for (const Axes& axes : coordinate_planes(points)) {
    if (orientation(points, axes, triangle) != 0) return {axes.begin(), axes.end()};
  }
  return {};
}

int side_of_triangle(const Configuration& points, const Simplex& triangle, Vertex v) {
  if (contains(triangle, v)) return 0;
  return orientation(points, kSpace, Simplex{triangle[0], triangle[1], triangle[2], v});
}

bool lies_in_triangle(const Configuration& points, Vertex v, const Simplex& triangle,
                      std::span<const std::size_t> axes) {
  if (contains(triangle, v)) return true;
  if (side_of_triangle(points, triangle, v) != 0) return false;
  const int front = orientation(points, axes, triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    const Simplex at_edge = {triangle[i], triangle[(i + 1) % 3], v};
    if (orientation(points, axes, at_edge) == -front) return false;
  }
  return true;
}

bool segment_pierces_triangle(const Configuration& points, const Simplex& segment,
                              const Simplex& triangle) {
  const int side = side_of_triangle(points, triangle, segment[0]);
  if (side == 0 || side_of_triangle(points, triangle, segment[1]) != -side) return false;
  bool left = false, right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Simplex skew = {segment[0], segment[1], triangle[i], triangle[(i + 1) % 3]};
    const int turn = orientation(points, kSpace, skew);
    left = left || turn > 0;
    right = right || turn < 0;
    if (left && right) return false;
  }
  return true;
}

bool interiors_meet(const Configuration& points, std::span<const std::size_t> axes,
                    const Simplex& a, const Simplex& b) {
  // Two convex polygons of a plane have disjoint interiors iff the line of an edge separates them.
  return !an_edge_separates(points, axes, a, b) && !an_edge_separates(points, axes, b, a);
}

}  // namespace circumspect
