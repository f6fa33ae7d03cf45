// The constrained Delaunay triangulation of a PLC in space by gift-wrapping, or why there is none.
// Book: Section 5.6.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::constrained {

// The evidence that a PLC has no CDT. The book names two kinds: a facet that cannot be finished,
// which is the first of these, and a tetrahedron that is not constrained Delaunay, which the others
// show.
enum class WhyNoCdt {
  kFacetUnfinished,     // no tetrahedron in front of the facet is clear of all polygons
  kPolygonCrosses,      // a polygon's triangle runs through the tetrahedron that should be there
  kSegmentCrosses,      // the segment runs through the tetrahedron that should be there
  kSimplicesOverlap,    // two tetrahedra are in each other's way
  kNotLocallyDelaunay,  // the vertex is in the ball of the tetrahedron behind the facet
  kSegmentMissing,      // the segment is not an edge of the triangulation
};

struct NoCdt {
  WhyNoCdt why;
  // The facet (three vertices) or the tetrahedron that shows it; empty if something is missing.
  Simplex simplex;
  // What is missing or in the way; the vertex in the ball.
  Simplex witness;

  bool operator==(const NoCdt&) const = default;
};

// The canonical CDT of a PLC in space. Both outcomes are values: the algorithm decides, in
// polynomial time, whether the PLC under the canonical perturbation has a CDT.
//
// Why. Suppose that there is one, T. Its triangles in the polygons are their planar CDTs
// (Proposition 4.11), the seeds. Let f be a facet of T and v the apex of the tetrahedron in front.
// Of all vertices in front of f and visible from its relative interior, v comes first in the pencil
// of spheres through f: any before it would be in the ball of f and v, and visible from points
// inside the tetrahedron as well. So the wrapping, which counts as visible a vertex whose
// tetrahedron with f is clear of all polygons (then it is visible; and v counts as visible), finds
// T and nothing else.
//
// Conversely, let the wrapping end. The boundary of its tetrahedra, as a chain of oriented facets,
// is that of the domain; so every point of the domain is covered once, and no other point. (For the
// hull kind, the hull's own facets are not given in advance, so all of the hull might be covered c
// more times. One sample point shows that c = 0.) Tetrahedra that tile facet to facet, with
// triangulated polygons for facets, do so face to face. If all segments and vertices of the domain
// are there, it is a triangulation of the PLC; if besides every facet that no polygon includes is
// locally Delaunay, it is a CDT by Lemma 4.10. If any of that fails, what has been found is not the
// CDT, and by the first part there is none.
//
// Requires: complex.ambient_dimension() == 3; the complex is valid. (A hull without volume has
// nothing inside.)
tl::expected<PlcTriangulation, NoCdt> gift_wrapping_cdt(const PiecewiseLinearComplex& complex,
                                                        const Progress& progress = {});

// The part of a CDT that every PLC has: the planar CDTs of all its polygons. Ascending, in
// lexicographic order.
std::vector<Simplex> triangulated_polygons(const PiecewiseLinearComplex& complex);

}  // namespace circumspect::constrained
