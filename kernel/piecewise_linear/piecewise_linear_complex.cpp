#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/cell_index.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/orientation.hpp"

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

// ---- Piecewise linear complex ----

// From lines to linear cells.

namespace {

// All vertices and segments, for finding those that lie in a polygon.
class Assembly {
 public:
  Assembly(const PointSet& points, const std::vector<Simplex>& segments)
      : points_(points),
        boxes_(points),
        vertices_(boxes_.of_vertices()),
        neighbours_(points.size()) {
    for (const Simplex& segment : segments) {
      neighbours_[static_cast<std::size_t>(segment[0])].push_back(segment[1]);
    }
  }

  Polygon polygon(const PolygonLines& lines) const {
    Polygon polygon;
    polygon.hole_seeds = lines.hole_seeds;
    std::vector<Vertex> vertices = vertices_of(lines);
    const std::set<Simplex> listed = edges_of(lines);
    const std::vector<Simplex> walls(listed.begin(), listed.end());
    polygon.axes = axes_of(vertices);
    if (polygon.axes.size() != 2) return polygon;
    const bool is_triangle = vertices.size() == 3 && walls.size() == 3 && lines.hole_seeds.empty();
    if (is_triangle) {
      polygon.triangles = {vertices};
    } else {
      polygon.triangles =
          polygon_triangles(points_, polygon.axes, vertices, walls, polygon.hole_seeds);
    }
    const std::vector<Vertex> inside = vertices_in(polygon);
    const std::vector<Simplex> slits = segments_between(inside);
    const std::size_t count = vertices.size();
    vertices.insert(vertices.end(), inside.begin(), inside.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const bool has_slits = std::any_of(slits.begin(), slits.end(),
                                       [&](const Simplex& s) { return !listed.contains(s); });
    if (vertices.size() > count || has_slits) {
      polygon.triangles =
          polygon_triangles(points_, polygon.axes, vertices, walls, polygon.hole_seeds, slits);
    }
    // The triangles have all these vertices and segments for corners and edges, and those that lie
    // outside or in a hole are left with none.
    std::set<Simplex> edges;
    for (const Simplex& triangle : polygon.triangles) {
      for (std::size_t i = 0; i < 3; ++i) edges.insert(facet_opposite(triangle, i));
    }
    polygon.vertices = inside;
    std::copy_if(slits.begin(), slits.end(), std::back_inserter(polygon.segments),
                 [&](const Simplex& s) { return edges.contains(s); });
    return polygon;
  }

 private:
  // Axes on which the plane of a polygon projects injectively; fewer if it has no plane.
  std::vector<std::size_t> axes_of(const std::vector<Vertex>& vertices) const {
    if (vertices.size() != 3) return flat_through(points_, vertices).axes;
    return axes_of_plane(points_.configuration(), vertices);
  }

  // All vertices in the triangles of a polygon.
  std::vector<Vertex> vertices_in(const Polygon& polygon) const {
    std::set<Vertex> found;
    for (const Simplex& triangle : polygon.triangles) {
      found.insert(triangle.begin(), triangle.end());
      for (const std::size_t place : vertices_.meeting(boxes_.of(triangle))) {
        const auto v = static_cast<Vertex>(place);
        if (found.contains(v)) continue;
        if (lies_in_triangle(points_.configuration(), v, triangle, polygon.axes)) found.insert(v);
      }
    }
    return {found.begin(), found.end()};
  }

  // All segments with both ends among some vertices, in lexicographic order.
  std::vector<Simplex> segments_between(const std::vector<Vertex>& vertices) const {
    std::vector<Simplex> found;
    for (const Vertex v : vertices) {
      for (const Vertex w : neighbours_[static_cast<std::size_t>(v)]) {
        if (std::binary_search(vertices.begin(), vertices.end(), w)) found.push_back({v, w});
      }
    }
    return found;
  }

  const PointSet& points_;
  CellBoxes boxes_;
  BoxIndex vertices_;
  std::vector<std::vector<Vertex>> neighbours_;  // the greater ends of segments, ascending
};

}  // namespace

PiecewiseLinearComplex assemble(const PiecewiseLinearInput& input) {
  PiecewiseLinearComplex complex{
      PointSet(input.points), segments_of(input), {}, input.hole_seeds, input.kind};
  if (input.polygons.empty()) return complex;
  const Assembly assembly(complex.points, complex.segments);
  complex.polygons.reserve(input.polygons.size());
  for (const PolygonLines& polygon : input.polygons) {
    complex.polygons.push_back(assembly.polygon(polygon));
  }
  return complex;
}

std::vector<Simplex> walls(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) return complex.segments;
  std::vector<Simplex> triangles;
  for (const Polygon& polygon : complex.polygons) {
    triangles.insert(triangles.end(), polygon.triangles.begin(), polygon.triangles.end());
  }
  return triangles;
}

namespace {

template <typename T>
void keep_each_once(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

std::set<Simplex> edges_of(const PolygonLines& polygon) {
  std::set<Simplex> edges;
  for (const std::vector<Vertex>& line : polygon.lines) {
    if (line.size() < 2) continue;
    for (std::size_t i = 0; i < line.size(); ++i) {
      edges.insert(sorted({line[i], line[(i + 1) % line.size()]}));
    }
  }
  return edges;
}

std::vector<Vertex> vertices_of(const PolygonLines& polygon) {
  std::vector<Vertex> vertices;
  for (const auto& line : polygon.lines) vertices.insert(vertices.end(), line.begin(), line.end());
  keep_each_once(vertices);
  return vertices;
}

std::vector<Simplex> segments_of(const PiecewiseLinearInput& input) {
  std::vector<Simplex> segments;
  for (const auto& segment : input.segments) segments.push_back(sorted(segment));
  for (const PolygonLines& polygon : input.polygons) {
    for (const Simplex& edge : edges_of(polygon)) segments.push_back(edge);
  }
  keep_each_once(segments);
  return segments;
}

}  // namespace circumspect
