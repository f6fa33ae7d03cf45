#include "oracle/judge/within/cells.hpp"

#include <algorithm>
#include <utility>

namespace circumspect::check {

Cells::Cells(const PiecewiseLinearComplex& complex, Markers markers)
    : complex_(complex), markers_(std::move(markers)), stars_(complex.points.size()) {
  for (std::size_t s = 0; s < complex.segments.size(); ++s) {
    for (const Vertex v : complex.segments[s])
      stars_[static_cast<std::size_t>(v)].push_back({1, s});
  }
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    for (const Vertex v : complex.polygons[p].vertices) {
      stars_[static_cast<std::size_t>(v)].push_back({2, p});
    }
  }
  for (const Polygon& polygon : complex.polygons) {
    std::vector<std::size_t>& places = segments_of_.emplace_back();
    for (const Simplex& segment : polygon.segments) {
      const auto at = std::lower_bound(complex.segments.begin(), complex.segments.end(), segment);
      places.push_back(static_cast<std::size_t>(at - complex.segments.begin()));
    }
    std::sort(places.begin(), places.end());
  }
}

std::vector<Cell> Cells::closure(Cell cell) const {
  std::vector<Cell> cells = {cell};
  if (cell.dimension == 0) return cells;
  for (const Vertex v : vertices(cell)) cells.push_back({0, static_cast<std::size_t>(v)});
  if (cell.dimension == 2) {
    for (const std::size_t s : segments_of_[cell.place]) cells.push_back({1, s});
  }
  return cells;
}

bool Cells::is_in_closure(Cell face, Cell cell) const {
  if (face.dimension >= cell.dimension) return face == cell;
  if (face.dimension == 1) {
    const std::vector<std::size_t>& segments = segments_of_[cell.place];
    return std::binary_search(segments.begin(), segments.end(), face.place);
  }
  const auto v = static_cast<Vertex>(face.place);
  if (cell.dimension == 1) return contains(complex_.segments[cell.place], v);
  const std::vector<Vertex>& vertices = complex_.polygons[cell.place].vertices;
  return std::binary_search(vertices.begin(), vertices.end(), v);
}

bool Cells::is_marked(const Simplex& triangle, std::size_t polygon) const {
  if (polygon >= markers_.of_polygons.size() || markers_.of_polygons[polygon] == 0) return false;
  const auto own = markers_.of_triangles.find(triangle);
  return own != markers_.of_triangles.end() && own->second == markers_.of_polygons[polygon];
}

bool Cells::meet(Cell a, Cell b) const {
  if (a.dimension == 0) return is_in_closure(a, b);
  const std::vector<Vertex> of_a = vertices(a);
  return std::any_of(of_a.begin(), of_a.end(), [&](Vertex v) {
    return is_in_closure({0, static_cast<std::size_t>(v)}, b);
  });
}

}  // namespace circumspect::check
