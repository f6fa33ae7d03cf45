// From what the fast engine knows of a mesh to the verdict that judge_points() gives on it.
#pragma once

#include <cstddef>

#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/points/check.hpp"

namespace circumspect::check {

// What judge_points() says of the mesh, word for word; the facets that are not locally Delaunay are asked
// again, exactly, on no more of the mesh than they need. Throws std::logic_error if the facts are not true.
// Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: the facts are those that
// fast::judge finds for the claim, and the mesh is oriented, if `options` demand it.
template <std::size_t kDimension, typename Index>
Verdict verdict_of_facts(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                         const fast::Facts& facts, const Options& options);

}  // namespace circumspect::check
