// Which simplices share a facet, where nobody says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/large_array.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

// Links with the memory for them.
struct OwnedLinks {
  LargeArray<std::int32_t> links;
  std::size_t count = 0;
  // Facets of three or more simplices, each as simplex · (d + 1) + place of the vertex opposite, ascending.
  // They have no links.
  std::vector<std::vector<std::uint64_t>> overused = {};

  std::span<const std::int32_t> view() const { return {links.get(), count}; }
};

// What is promised of links before they are verified.
enum class Proposal {
  // Facets of three simplices are seen if they meet by chance; the fastest.
  kLikely,
  // A facet without a link that is not overused is in no other simplex, and one with a link that is right
  // is in no third.
  kComplete,
};

// For each simplex and vertex the simplex across the facet opposite, or −1, as a program would list them.
// Facets are compared by hashes, and by their vertices only where the same hash comes up three times:
// what is returned is a proposal, which the sweep verifies like that of any other program. If it is
// wrong, hashes of 46 bits or more are equal by accident, and the mesh is left undecided.
// Undecided: an index that names no point; three simplices with one facet, unless the proposal is complete;
// more than 2^29 simplices.
// Memory: 4 (d + 1) bytes a simplex for the links, and as much again until it returns.
template <std::size_t kDimension, typename Index>
tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<kDimension, Index>& mesh,
                                                   unsigned threads,
                                                   Proposal proposal = Proposal::kComplete);

}  // namespace circumspect::fast
