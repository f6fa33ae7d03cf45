// From a CDT of the convex hull to one of the domain. Book: Section 4.5.1 (Definition 4.4).
#pragma once

#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// The tetrahedra in the polyhedra of the complex, and its dangling triangles, edges and vertices:
// without the tetrahedra that are joined, through facets that are no walls, to one that contains a
// hole seed or, if the domain is what the polygons enclose, to the outside.
// Requires: all polygons of the complex have been inserted.
PlcTriangulation carve(const PiecewiseLinearComplex& complex, const EvolvingCdt& cdt);

// A triangulation of d-simplices and the faces that are to be in it: those faces that are in no other
// simplex of it become the dangling ones.
PlcTriangulation with_dangling(std::vector<Simplex> simplices, const std::set<Simplex>& faces);

}  // namespace circumspect::constrained
