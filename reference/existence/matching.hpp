// Triangulations of a complex as the solutions of a propositional formula. Book: Section 4.5.1,
// Definition 4.4.
#pragma once

#include <vector>

#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "reference/existence/formula.hpp"

namespace circumspect::existence {

// The tetrahedra that a triangulation of a complex can consist of.

// Every tetrahedron with vertices of the complex that respects it, ascending, in lexicographic
// order. A triangulation has no others (Definition 4.4), whatever its vertices' order. Requires:
// the complex is in space.
std::vector<Simplex> respecting_tetrahedra(const PiecewiseLinearComplex& complex,
                                           const Regions& regions);

// The constrained Delaunay ones among these, without perturbation. Book: Definition 4.6.
std::vector<Simplex> constrained_delaunay_tetrahedra(const PiecewiseLinearComplex& complex,
                                                     const Regions& regions);

// Variable i + 1 says that tetrahedron i is chosen. The formula is true iff the chosen ones are a
// triangulation of the polyhedra of the complex (Definition 4.4). Its clauses:
//  1. At most one of the tetrahedra on one side of a facet is chosen.
//  2. A chosen tetrahedron has a chosen one across each of its facets that has some of the domain
//     on its other side.
//  3. For each region of the domain: of the tetrahedra that reach some point on its boundary from
//     within, exactly one is chosen.
//
// Why that suffices. By 2 and 1 each facet of a chosen tetrahedron within a region has exactly one
// on either side, so that the number of chosen tetrahedra that hold a point is the same on both
// sides; no tetrahedron crosses a wall; so that number is constant over a region. By 3 it is one:
// the chosen ones cover each region once, and nothing else, for each lies in the domain. They meet
// in common faces: none holds a vertex but its own, so two that do not would have edges that cross
// in a point, or an edge that pierces a facet; but those around a face cover all of the domain near
// it, on both sides of a polygon alike by 2, which leaves no room for a second one there. Each
// segment and each vertex of the domain is covered by tetrahedra that meet it in a face, hence is a
// face; a polygon with some of the domain beside it is a union of faces for the same reason.
// Conversely, each clause holds for every triangulation.
//
// Requires: every tetrahedron respects the complex; vertices ascending.
Formula matching_formula(const PiecewiseLinearComplex& complex, const Regions& regions,
                         const std::vector<Simplex>& tetrahedra);

}  // namespace circumspect::existence
