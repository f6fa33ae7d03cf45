// The facets of a mesh as words of 64 bits, and the search for facets that two simplices share.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/judge/fast/mesh_view.hpp"

namespace circumspect::fast {

// The facets of a mesh as words of 64 bits, put into piles small enough for a cache.

inline int bits_of(std::uint64_t number) { return static_cast<int>(std::bit_width(number)); }

// The last steps of splitmix64: inputs that differ in one bit differ in about half of the bits
// afterwards.
inline std::uint64_t mixed_vertex(std::uint64_t v) {
  v = (v + 1) * 0xbf58476d1ce4e5b9U;
  v ^= v >> 32;
  v *= 0x94d049bb133111ebU;
  return v ^ (v >> 29);
}

// A record holds, from the top, the low bits of a hash of the facet's vertices and which facet of
// which simplex it is: simplex · (d + 1) + place of the vertex opposite.
class RecordLayout {
 public:
  // Requires: fewer than 2^62 facets. The number with all bits set is not a facet.
  explicit RecordLayout(std::uint64_t facets) : bits_(bits_of(facets + 1)) {}

  std::uint64_t record(std::uint64_t hash, std::uint64_t facet) const {
    return hash << bits_ | facet;
  }
  std::uint64_t hash(std::uint64_t record) const { return record >> bits_; }
  std::uint64_t facet(std::uint64_t record) const { return record & no_facet(); }
  std::uint64_t no_facet() const { return (std::uint64_t{1} << bits_) - 1; }
  bool same_hash(std::uint64_t a, std::uint64_t b) const { return hash(a ^ b) == 0; }

 private:
  int bits_;
};

// Calls visit(hash, place of the vertex opposite) for each facet of a row.
template <std::size_t kVertices, typename Index, typename Visit>
[[gnu::always_inline]] inline void for_each_facet_of(std::span<const Index, kVertices> row,
                                                     const Visit& visit) {
  std::array<std::uint64_t, kVertices> mixed;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < kVertices; ++i) {
    mixed[i] = mixed_vertex(static_cast<std::uint64_t>(row[i]));
    sum += mixed[i];
  }
  for (std::size_t i = 0; i < kVertices; ++i) visit(sum - mixed[i], i);
}

// Pairs of records with the same hash, found without unpredictable branches.

// Adds up the records of each slot of a table, chosen by bits of their hashes after the first
// `skipped`. If two are alone in a slot, the sum minus one record is the other; otherwise the
// difference most likely has another hash. Calls found(record, other, is_pair) for each record;
// those without a partner are moved to the front. Returns their number.
template <typename Found>
std::size_t pair_by_sums(const RecordLayout& layout, std::span<std::uint64_t> records, int skipped,
                         std::vector<std::uint64_t>& sums, const Found& found) {
  if (records.empty()) return 0;
  const int shift = 64 - bits_of(records.size());
  sums.assign(std::size_t{1} << (64 - shift), 0);
  const auto sum_of = [&](std::uint64_t record) -> std::uint64_t& {
    return sums[static_cast<std::size_t>(record << skipped >> shift)];
  };
  for (const std::uint64_t record : records) sum_of(record) += record;
  std::size_t left = 0;
  for (const std::uint64_t record : records) {
    const std::uint64_t other = sum_of(record) - record;
    const bool is_pair = layout.same_hash(record, other);
    found(record, other, is_pair);
    records[left] = record;
    left += static_cast<std::size_t>(!is_pair);
  }
  return left;
}

// Facets shared by two simplices that are near each other in the list, as most are in the order in
// which programs write their meshes.

// Remembers facets for a while, in a table that stays in a cache, where each new one replaces
// another. Nothing here branches on what is found, because that would be unpredictable.
template <std::size_t kDimension, typename Index>
class NearbyFacets {
 public:
  static constexpr std::size_t kVertices = kDimension + 1;

  // `links` are those of the whole mesh; `left[pile]` counts facets that were forgotten without a
  // partner. Requires: the number of piles is a power of two; at most `simplices` simplices will
  // come.
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
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};  // the only value with the top bit set

  std::size_t pile(std::uint64_t record) const { return layout_.hash(record) & (left_.size() - 1); }

  RecordLayout layout_;
  std::int32_t* links_;
  std::span<std::uint32_t> left_;
  int bits_;
  std::vector<std::uint64_t> recent_;
};

// A facet as two simplices list it.

// For each vertex, the places of the others, in an order such that the vertex followed by them is
// an even permutation of the row.
template <std::size_t kVertices>
inline constexpr std::array<std::array<std::size_t, kVertices - 1>, kVertices> kFacetPlaces{};
template <>
inline constexpr std::array<std::array<std::size_t, 2>, 3> kFacetPlaces<3> = {
    {{1, 2}, {2, 0}, {0, 1}}};
template <>
inline constexpr std::array<std::array<std::size_t, 3>, 4> kFacetPlaces<4> = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

// All ones if they are equal, else 0. These are masks instead of conditions, because compilers turn
// conditions into branches.
template <typename Index>
[[gnu::always_inline]] inline Index mask_if_equal(Index a, Index b) {
  return static_cast<Index>(-static_cast<Index>(a == b));
}
template <typename Index>
[[gnu::always_inline]] inline Index select(Index mask, Index a, Index b) {
  return static_cast<Index>(b ^ (mask & (a ^ b)));
}

// Does g list the same vertices as f, in an order that is an even or an odd permutation? The
// answers are masks.
template <typename Index>
struct SameVertices {
  Index even, odd;
};
template <typename Index>
[[gnu::always_inline]] inline SameVertices<Index> same_vertices(const std::array<Index, 2>& f,
                                                                const std::array<Index, 2>& g) {
  const Index even = mask_if_equal(f[0], g[0]) & mask_if_equal(f[1], g[1]);
  const Index odd = mask_if_equal(f[0], g[1]) & mask_if_equal(f[1], g[0]);
  return {even, odd};
}
template <typename Index>
[[gnu::always_inline]] inline SameVertices<Index> same_vertices(const std::array<Index, 3>& f,
                                                                const std::array<Index, 3>& g) {
  std::array<std::array<Index, 3>, 3> same;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) same[i][k] = mask_if_equal(f[i], g[k]);
  }
  const Index even = (same[0][0] & same[1][1] & same[2][2]) |
                     (same[0][1] & same[1][2] & same[2][0]) |
                     (same[0][2] & same[1][0] & same[2][1]);
  const Index odd = (same[0][0] & same[1][2] & same[2][1]) |
                    (same[0][1] & same[1][0] & same[2][2]) | (same[0][2] & same[1][1] & same[2][0]);
  return {even, odd};
}

// How the rows of two simplices that share the facet opposite a vertex of the first fit together.
// Yes is a mask of ones, no is 0.
template <typename Index>
struct Fit {
  Index matches;  // the second has all vertices of the facet, and not the first's own apex
  Index odd;      // the permutation from the first row, apex for apex, to the second
  Index place;    // of the second's apex in its row …
  Index apex;     // … and that
};

// `first` lists the apex, then the facet as in kFacetPlaces; `second` is the other simplex's row.
// Inlined into loops over many facets (block.cpp). Both simplices lie on opposite sides of the
// facet iff the product of their orientations is −1 times the sign of the permutation: putting the
// one apex in the other's place changes the orientation. Requires for the answer to have that
// meaning: neither row has a vertex twice (their orientations are not zero).
template <std::size_t kVertices, typename Index>
[[gnu::always_inline]] inline Fit<Index> fit_of(const std::array<Index, kVertices>& first,
                                                const std::array<Index, kVertices>& second) {
  constexpr std::size_t kOthers = kVertices - 1;
  // The vertices in one row only: if the facet is shared, the two apexes.
  Index other = 0;
  for (std::size_t i = 0; i < kVertices; ++i) other ^= first[i] ^ second[i];
  other ^= first[0];
  Index place = 0;
  std::array<Index, kOthers> facet, again;
  for (std::size_t k = 0; k < kOthers; ++k) {
    facet[k] = first[k + 1];
    again[k] = second[kFacetPlaces<kVertices>[0][k]];
  }
  for (std::size_t i = 1; i < kVertices; ++i) {
    const Index is_apex = mask_if_equal(second[i], other);
    place = select(is_apex, static_cast<Index>(i), place);
    for (std::size_t k = 0; k < kOthers; ++k) {
      again[k] = select(is_apex, second[kFacetPlaces<kVertices>[i][k]], again[k]);
    }
  }
  // If all vertices of the facet are found again, `other` is what remains.
  const SameVertices<Index> same = same_vertices(facet, again);
  const Index matches = (same.even | same.odd) & ~mask_if_equal(other, first[0]);
  return {matches, same.odd, place, other};
}

}  // namespace circumspect::fast
