// Sets of vertices, each with where it comes from, in lexicographic order: the faces of large
// meshes.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "kernel/exact/interruption.hpp"

namespace circumspect {

// By odd-even transposition, since branches would be unpredictable.
template <std::size_t kSize>
[[gnu::always_inline]] inline void sort_vertices(std::array<std::int32_t, kSize>& set) {
  for (std::size_t round = 0; round < kSize; ++round) {
    for (std::size_t i = round % 2; i + 1 < kSize; i += 2) {
      const std::int32_t low = std::min(set[i], set[i + 1]);
      set[i + 1] = std::max(set[i], set[i + 1]);
      set[i] = low;
    }
  }
}

// Each set has kSize vertices. They are sorted by the least one first, which few sets share, so
// that it takes little more than two passes over them.
template <std::size_t kSize>
class VertexSets {
 public:
  using Set = std::array<std::int32_t, kSize>;
  struct Entry {
    std::array<std::int32_t, kSize - 1> others;  // all vertices but the least, ascending
    std::int32_t origin;

    bool has_same_others(const Entry& entry) const { return others == entry.others; }
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  // `each(visit)` calls visit(set, origin) for all sets, twice the same ones; their vertices may
  // be in any order. Requires: 0 <= v < points for each vertex; fewer than 2^32 sets.
  template <class Each>
  VertexSets(std::size_t points, const Each& each) : begins_(points + 1) {
    each([&](const Set& set, std::int32_t) {
      ++begins_[static_cast<std::size_t>(*std::min_element(set.begin(), set.end())) + 1];
    });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    entries_.resize(begins_.back());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    each([&](Set set, std::int32_t origin) {
      sort_vertices(set);
      Entry& entry = entries_[next[static_cast<std::size_t>(set.front())]++];
      std::copy(set.begin() + 1, set.end(), entry.others.begin());
      entry.origin = origin;
    });
    for (std::size_t v = 0; v < points; ++v) {
      if (v % 4096 == 0) end_if_interrupted();
      std::sort(entries_.begin() + begins_[v], entries_.begin() + begins_[v + 1]);
    }
  }

  std::size_t points() const { return begins_.size() - 1; }

  // The sets whose least vertex is v, in lexicographic order; equal ones by their origins.
  std::span<const Entry> with_least(std::size_t v) const {
    return std::span(entries_).subspan(begins_[v], begins_[v + 1] - begins_[v]);
  }

  // Those at the beginning of a part of with_least(v) that are equal.
  static std::span<const Entry> first_group(std::span<const Entry> entries) {
    std::size_t size = 1;
    while (size < entries.size() && entries[size].has_same_others(entries[0])) ++size;
    return entries.first(size);
  }

  // Calls visit(v, group) for all sets that are equal, v their least vertex, in order.
  template <class Visit>
  void for_each_group(const Visit& visit) const {
    for (std::size_t v = 0; v < points(); ++v) {
      for (auto left = with_least(v); !left.empty();) {
        const auto group = first_group(left);
        visit(static_cast<std::int32_t>(v), group);
        left = left.subspan(group.size());
      }
    }
  }

 private:
  std::vector<std::uint32_t> begins_;  // of the sets with each least vertex
  std::vector<Entry> entries_;
};

}  // namespace circumspect
