// Are linear cells a piecewise linear complex? Book: Definition 4.3.
#pragma once

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::definition {

// "The vertices and edges in P form a simplicial complex.
//  For each linear cell f ∈ P, the boundary of f is a union of linear cells in P.
//  If two distinct linear cells f, g ∈ P intersect, their intersection is a union of linear cells
//  in P, all having lower dimension than at least one of f or g."
//
// All cells against all others. What two cells have in common is found triangle by triangle, and
// asked is whether segments and vertices cover it. (One that covers a part of it lies in both cells
// as a whole, or it would break the third condition itself.) Polyhedra are what polygons enclose,
// and meet in what these allow. A polygon is the part of a plane that its triangles cover.
// Requires: segments have two ends each, triangles three corners that are not on one line; in the
// plane no polygon is listed.
bool is_piecewise_linear_complex(const PiecewiseLinearComplex& complex);

}  // namespace circumspect::definition
