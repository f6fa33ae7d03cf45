// From what the fast judge knows of a mesh to the verdict that judge() gives on it.
#pragma once

#include <cstddef>

#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/points/check.hpp"

namespace circumspect::check {

// A verdict, and the mesh that its witnesses name: no more of the one that was judged than they need, with
// the user's indices for labels.
struct FlatVerdict {
  Verdict verdict;
  Mesh named;
};

// What judge() says of the mesh, word for word; the facets that are not locally Delaunay are asked again,
// exactly. `first_index`: the user's index of the first point. Throws std::logic_error if the facts are not
// true. Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: the facts are those that
// fast::judge finds for the claim, and the mesh is oriented, if `options` demand it.
template <std::size_t kDimension, typename Index>
FlatVerdict verdict_of_facts(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                             Vertex first_index, const fast::Facts& facts, const Options& options);

}  // namespace circumspect::check
