// Piecewise linear complexes that have a name.
#pragma once

#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::generators {

// The axis-parallel box with corners (low, low, low) and (high, high, high): 8 vertices in binary
// order of their coordinates (x lowest), 6 square polygons.
PiecewiseLinearInput box(const Rational& low, const Rational& high);

// Schönhardt's polyhedron: vertices 0 1 2 below, 3 4 5 above and turned; 8 triangles, of which the
// edges 0 4, 1 5, 2 3 are reflex. No triangulation. Book: Figure 4.10.
PiecewiseLinearInput schonhardt();

// Two inputs in one, the vertices of the second numbered after those of the first.
PiecewiseLinearInput both(PiecewiseLinearInput first, const PiecewiseLinearInput& second);

}  // namespace circumspect::generators
