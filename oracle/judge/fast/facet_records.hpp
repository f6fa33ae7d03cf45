// The facets of a mesh as words of 64 bits, put into piles small enough for a cache.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace circumspect::fast {

inline int bits_of(std::uint64_t number) { return static_cast<int>(std::bit_width(number)); }

// splitmix64's last steps: what differs in one bit differs in half of them afterwards.
inline std::uint64_t mixed_vertex(std::uint64_t v) {
  v = (v + 1) * 0xbf58476d1ce4e5b9U;
  v ^= v >> 32;
  v *= 0x94d049bb133111ebU;
  return v ^ (v >> 29);
}

// A record holds, from the top, the low bits of a hash of the facet's vertices and which facet of which
// simplex it is: simplex · (d + 1) + place of the vertex opposite.
class RecordLayout {
 public:
  // Requires: fewer than 2^62 facets. The number with all bits set is no facet.
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

}  // namespace circumspect::fast
