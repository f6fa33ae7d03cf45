#include "kernel/piecewise_linear/linear_cell.hpp"

#include <algorithm>

namespace circumspect {

std::vector<LinearCell> linear_cells(const PiecewiseLinearComplex& complex) {
  std::vector<LinearCell> cells;
  for (std::size_t v = 0; v < complex.points.size(); ++v) cells.push_back({0, v});
  for (std::size_t s = 0; s < complex.segments.size(); ++s) cells.push_back({1, s});
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) cells.push_back({2, p});
  return cells;
}

std::vector<Vertex> vertices_of(const PiecewiseLinearComplex& complex, LinearCell cell) {
  if (cell.dimension == 0) return {static_cast<Vertex>(cell.place)};
  return cell.dimension == 1 ? complex.segments[cell.place] : complex.polygons[cell.place].vertices;
}

std::vector<Simplex> simplices_of(const PiecewiseLinearComplex& complex, LinearCell cell) {
  if (cell.dimension == 2) return complex.polygons[cell.place].triangles;
  return {vertices_of(complex, cell)};
}

bool is_face(const PiecewiseLinearComplex& complex, LinearCell face, LinearCell cell) {
  if (face.dimension >= cell.dimension) return face == cell;
  if (face.dimension == 0) {
    return contains(vertices_of(complex, cell), static_cast<Vertex>(face.place));
  }
  const std::vector<Simplex>& segments = complex.polygons[cell.place].segments;
  return std::count(segments.begin(), segments.end(), complex.segments[face.place]) > 0;
}

}  // namespace circumspect
