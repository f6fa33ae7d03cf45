// Is a vertex visible from a simplex? Book: Definitions 2.11 and 2.13, quoted in Section 4.5.2: "A
// linear cell in P that intersects the relative interior of xy but does not include xy occludes the
// visibility between x and y."
#pragma once

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::definition {

// Is there a point x in the relative interior of the simplex σ from which the vertex v is visible?
//
// What is computed is the existence of x: unknown are its barycentric coordinates λ > 0 in σ. It
// lies in the shadow of a cell, seen from v, where a few functions that are linear in λ are not
// negative; so x must make one of them negative for each cell. All choices are tried, each is a
// linear program.
//
// Only cells whose shadow has interior points in σ are looked at: triangles of polygons with v off
// their plane; if σ is a triangle, also segments in its plane. All other shadows lie in lines and
// planes that do not contain σ, and x can avoid them, because the others leave an open set. A
// polygon in the plane of a triangle σ occludes nothing that its segments do not: a line that
// enters or leaves it crosses one. And xv ⊆ |P|: it begins in σ, so it is in the region, or the
// polygon, of σ, and leaves that nowhere without crossing a cell.
// Requires: σ has two or three dimensions and respects the complex, as a simplex of a triangulation
// of it does; v is in its affine hull and not in σ.
bool is_visible(const PiecewiseLinearComplex& complex, Vertex v, const Simplex& simplex);

}  // namespace circumspect::definition
