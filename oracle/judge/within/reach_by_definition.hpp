// The definition of docs/theory/within.md, word for word.
#pragma once

#include "oracle/judge/within/reach_search.hpp"

namespace circumspect::check {

// As least_reach, by trying every distance and every set of triangles. Exponential in the number of
// triangles near a polygon. Of what it does not find it only says whether it passed over ambiguous
// reaches.
// Requires: as least_reach; at most kMostTriangles triangles of the mesh near a polygon.
ReachAnswer least_reach_by_definition(const ExactMesh& mesh, const std::vector<bool>& used,
                                      const Cells& cells, const Regions& regions,
                                      const Rational& squared_limit);
inline constexpr std::size_t kMostTriangles = 14;

// Is it within the requirement?
bool is_small_enough_for_definition(const ExactMesh& mesh, const std::vector<bool>& used,
                                    const Cells& cells, const Rational& squared_limit,
                                    std::size_t most = kMostTriangles);

}  // namespace circumspect::check
