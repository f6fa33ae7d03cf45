// Point location by looking at every simplex. Book: Section 5.2.
#pragma once

#include <optional>

#include "reference/complex/dictionary.hpp"
#include "reference/complex/point_set.hpp"
#include "reference/delaunay/statistics.hpp"

namespace circumspect::delaunay {

// Some simplex of the dictionary, solid or ghost, in conflict with q; nothing if there is none,
// because q is submerged. Requires: q is not a vertex of the dictionary's simplices.
std::optional<Simplex> linear_scan(const PointSet& points, const SimplexDictionary& dictionary,
                                   Vertex q, Statistics& statistics);

}  // namespace circumspect::delaunay
