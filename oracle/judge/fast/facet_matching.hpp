// Finds which simplices share a facet if no neighbours are given. Also provides memory for the
// large arrays that this needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/undecided.hpp"
#include "platform/memory.hpp"

namespace circumspect::fast {

// Memory for large arrays. It is not initialized, so that the threads that write it touch it first,
// and in large pages if the system offers them: writes all over an array then cause fewer TLB
// misses and fewer page faults.
struct Unmapped {
  std::size_t bytes = 0;

  void operator()(void* memory) const { platform::unmap_memory(memory, bytes); }
};

// T[] of a type that needs neither constructor nor destructor.
template <typename T>
using LargeArray = std::unique_ptr<T[], Unmapped>;

// Large arrays come directly from the system and return to it, because memory that an allocator
// keeps would count as in use. Throws std::bad_alloc.
template <typename T>
LargeArray<T> large_array(std::size_t count) {
  static_assert(std::is_trivial_v<T>);
  if (count > PTRDIFF_MAX / sizeof(T) - 1) throw std::bad_alloc();
  const std::size_t bytes = count * sizeof(T) + 1;
  return LargeArray<T>(static_cast<T*>(platform::map_memory(bytes)), Unmapped{bytes});
}

// Links that own their memory.
struct OwnedLinks {
  LargeArray<std::int32_t> links;
  std::size_t count = 0;
  // Facets of three or more simplices, each as simplex · (d + 1) + place of the vertex opposite,
  // ascending. They have no links.
  std::vector<std::vector<std::uint64_t>> overused = {};

  std::span<const std::int32_t> view() const { return {links.get(), count}; }
};

// What is guaranteed about links before they are verified.
enum class Proposal {
  // Finds facets of three simplices only if they meet by chance; the fastest.
  kLikely,
  // A facet without a link that is not overused is not in another simplex, and one with a correct
  // link is not in a third.
  kComplete,
};

// For each simplex and vertex, the simplex across the facet opposite, or −1, as a program would
// list them. Facets are compared by hashes, and by their vertices only if the same hash occurs
// three times, so the result is a proposal, which the sweep verifies like neighbours that a program
// lists. It is wrong only if hashes of 46 bits or more collide; then the mesh is left undecided.
// Undecided: an index that names no point; more than 2^29 simplices. Memory: 4 (d + 1) bytes a
// simplex for the links, and as much again until it returns.
template <std::size_t kDimension, typename Index>
tl::expected<OwnedLinks, Undecided> matched_facets(const MeshView<kDimension, Index>& mesh,
                                                   unsigned threads,
                                                   Proposal proposal = Proposal::kComplete);

// Makes links complete. Returns the facets that were matched again, ascending, as
// OwnedLinks::overused names them: all that share their vertices, or their hash, with a facet that
// they are not linked to. The links of all others are unchanged. Requires: the links come from
// matched_facets; a linked facet is the only one that is linked to its partner, which has the same
// vertices and is linked back.
template <std::size_t kDimension, typename Index>
std::vector<std::uint64_t> complete(const MeshView<kDimension, Index>& mesh, OwnedLinks& links,
                                    unsigned threads);

}  // namespace circumspect::fast
