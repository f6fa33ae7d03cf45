// From the places of a mesh that are at fault to the verdict that judge_points() gives on it.
#pragma once

#include <cstddef>
#include <optional>

#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/points/check.hpp"
#include "oracle/model/index_lists.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// What judge_points() says of the mesh, word for word: the exact checkers look again, in their order, at the
// places that are at fault, on no more of the mesh than they need. `neighbors`: those that the mesh lists, if
// it does.
// Nothing if the faults do not tell: weighted points of a triangulation that are no vertices, neighbours that
// are no rows of a simplex's width, or no fault at all.
// Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: the faults are those that
// fast::faults finds for the claim.
template <std::size_t kDimension, typename Index>
std::optional<Verdict> verdict_of_faults(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                                         const ListedNeighbors* neighbors,
                                         const fast::Faults& faults, const Options& options);

}  // namespace circumspect::check
