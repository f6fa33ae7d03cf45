// The linear cells of a complex, by name. Book: Section 4.5.1 ("each linear cell f ∈ P").
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// A vertex (dimension 0), a segment (1) or a polygon (2), by its place among them.
struct LinearCell {
  int dimension = 0;
  std::size_t place = 0;
  auto operator<=>(const LinearCell&) const = default;
};

// All of them, vertices first, polygons last.
std::vector<LinearCell> linear_cells(const PiecewiseLinearComplex& complex);

// The vertices in the cell; the simplices that it is made of.
std::vector<Vertex> vertices_of(const PiecewiseLinearComplex& complex, LinearCell cell);
std::vector<Simplex> simplices_of(const PiecewiseLinearComplex& complex, LinearCell cell);

// Is it the cell itself or a face of it? The vertices and segments in a polygon are faces of it.
bool is_face(const PiecewiseLinearComplex& complex, LinearCell face, LinearCell cell);

}  // namespace circumspect
