// Facets of a mesh in arrays, as the checkers name them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/judge/fast/facet_id.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/points/delaunay.hpp"

namespace circumspect::check {

// The answer is in no particular order. One pass over the mesh, and time for each facet.
// Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires: the mesh is a triangulation, and
// each of the facets is in two of its simplices and named once.
template <std::size_t kDimension, typename Index>
std::vector<SharedFacet> shared_facets(const fast::MeshView<kDimension, Index>& mesh,
                                       std::span<const fast::FacetId> facets);

}  // namespace circumspect::check
