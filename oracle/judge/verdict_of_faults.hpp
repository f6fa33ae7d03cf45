// Turns the answer of the fast judge about a mesh, facts or places at fault, into the verdict of
// judge_points() on it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/judge/ridges_retold.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// Facets of a mesh in arrays, as the checkers name them, in no particular order. One pass over the
// mesh, and time for each facet. Instances: dimensions 2 and 3; std::int32_t and std::int64_t.
// Requires: the mesh is a triangulation, and each of the facets is in two of its simplices and
// named once.
template <std::size_t kDimension, typename Index>
std::vector<SharedFacet> shared_facets(const fast::MeshView<kDimension, Index>& mesh,
                                       std::span<const fast::FacetId> facets);

// What judge_points() says of the mesh, word for word; the facets that are not locally Delaunay are
// asked again, exactly, on no more of the mesh than they need. Throws std::logic_error if the facts
// are not true. Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: the facts
// are those that fast::judge finds for the claim, and the mesh is oriented, if `options` demand it.
template <std::size_t kDimension, typename Index>
Verdict verdict_of_facts(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                         const fast::Facts& facts, const Options& options);

// What judge_points() says of the mesh, word for word: the exact checkers look again, in their
// order, at the places that are at fault, on no more of the mesh than they need. `neighbors`: those
// that the mesh lists, if it does.
// Nothing if the faults do not tell: weighted points of a triangulation that are not vertices,
// neighbours that are not rows of a simplex's width, or no fault at all.
// Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: the faults are those that
// fast::faults finds for the claim, but for the `further` ridges.
template <std::size_t kDimension, typename Index>
std::optional<Verdict> verdict_of_faults(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                                         const ListedNeighbors* neighbors,
                                         const fast::Faults& faults, const Options& options,
                                         const FurtherRidges& further = {});

}  // namespace circumspect::check
