// All triangulations of a small point set, their faces, and which of them are regular. Book:
// Sections 4.1 to 4.3.
#pragma once

#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::optimality {

// The simplicial complex that a triangulation is. Book: Section 4.1 ("its total number of simplices
// of all dimensions"). The simplices of all dimensions, each once: ascending vertices, small
// dimensions first.
std::vector<Simplex> simplicial_complex(const Triangulation& triangulation);

// All triangulations of a small point set, by exhaustive search. Book: Section 4.1; "compared with
// all other triangulations of the same points", Section 4.3.

// A triangulation of S has all of S as its vertices (Definition 2.1). Where flips of weighted
// triangulations count (Section 4.4), the vertices may be only some of the points, but always
// include the extreme ones.
enum class VertexUse { kAllPoints, kSomePoints };

// Every triangulation, each once, in ascending order of the lists of simplices. A set of dimension
// k has at most C(n, k+1) simplices to choose from; intended for n ≤ 9.
std::vector<Triangulation> all_triangulations(const PointSet& points,
                                              VertexUse use = VertexUse::kAllPoints);

// Which triangulations are regular: the weighted Delaunay triangulations for some weights.
// Book: Section 4.2 by way of Definition 2.5 (weighted Delaunay triangulations, which according to
// Section 4.3 are the optimal ones for some function).

// Heights, one a point, over which the triangulation is the whole lower hull: every interior facet
// is strictly convex, every point that is not a vertex strictly above. Nothing if there are none:
// the triangulation is not regular. By a linear program in the heights. Requires: a triangulation
// of the points, or of some of them.
std::optional<std::vector<Rational>> heights_of_regular(const PointSet& points,
                                                        const Triangulation& triangulation);

}  // namespace circumspect::optimality
