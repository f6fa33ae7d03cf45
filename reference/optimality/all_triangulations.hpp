// All triangulations of a small point set, by exhaustive search. Book: Section 4.1; "compared with
// all other triangulations of the same points", Section 4.3.
#pragma once

#include <vector>

#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect::optimality {

// A triangulation of S has all of S for its vertices (Definition 2.1). Where the flips of weighted
// triangulations count (Section 4.4), the vertices may be only some of the points, those that are
// extreme among them.
enum class VertexUse { kAllPoints, kSomePoints };

// Every triangulation, each once, in ascending order of the lists of simplices. A set of dimension k
// has at most C(n, k+1) simplices to choose from; intended for n ≤ 9.
std::vector<Triangulation> all_triangulations(const PointSet& points,
                                              VertexUse use = VertexUse::kAllPoints);

}  // namespace circumspect::optimality
