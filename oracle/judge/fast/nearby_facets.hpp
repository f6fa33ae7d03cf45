// The facets that two simplices share which stand near each other in the list: most facets, in the order in
// which programs write their meshes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/mesh_view.hpp"

namespace circumspect::fast {

// Remembers facets for a while: in a table that stays in a cache each new one takes the place of another.
// Nothing here branches on what is found, which is a coin toss.
template <std::size_t kDimension, typename Index>
class NearbyFacets {
 public:
  static constexpr std::size_t kVertices = kDimension + 1;

  // `links` are those of the whole mesh; `left[pile]` counts facets that were forgotten without a partner.
  // Requires: the number of piles is a power of two; at most `simplices` are to come.
  NearbyFacets(const RecordLayout& layout, std::size_t simplices, std::int32_t* links,
               std::span<std::uint32_t> left)
      : layout_(layout),
        links_(links),
        left_(left),
        bits_(std::min(kMostBits, bits_of(simplices * kVertices))),
        recent_(std::size_t{1} << bits_, kFree) {}

  // Links the facets of simplex s, and those of simplices before it; −1 where there is none so far.
  // Requires: the vertices are points.
  void add(std::span<const Index, kVertices> row, std::size_t s) {
    for_each_facet_of<kVertices, Index>(row, [&](std::uint64_t hash, std::size_t place) {
      const std::size_t facet = s * kVertices + place;
      const std::uint64_t record = layout_.record(hash, facet) & ~kTopBit;
      std::uint64_t& slot = recent_[hash >> (64 - bits_)];
      const std::uint64_t old = slot;
      const std::uint64_t other = layout_.facet(old);
      // All bits, if both are the same facet.
      const std::uint64_t same = -static_cast<std::uint64_t>(layout_.same_hash(old, record));
      slot = record | same;
      links_[facet] = static_cast<std::int32_t>((other / kVertices) | ~same);
      links_[facet ^ ((facet ^ other) & same)] = static_cast<std::int32_t>(s | ~same);
      left_[pile(old)] += static_cast<std::uint32_t>(~same & std::uint64_t{old != kFree});
    });
  }

  // Forgets the facets that are left.
  void finish() {
    for (std::uint64_t& slot : recent_) {
      if (slot != kFree) ++left_[pile(slot)];
      slot = kFree;
    }
  }

 private:
  static constexpr int kMostBits = 15;
  static constexpr std::uint64_t kTopBit = std::uint64_t{1} << 63;
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};  // the only one with the top bit

  std::size_t pile(std::uint64_t record) const { return layout_.hash(record) & (left_.size() - 1); }

  RecordLayout layout_;
  std::int32_t* links_;
  std::span<std::uint32_t> left_;
  int bits_;
  std::vector<std::uint64_t> recent_;
};

}  // namespace circumspect::fast
