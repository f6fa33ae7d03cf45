// How much more often one of two large meshes lists each set of vertices than the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace circumspect::check {

// A hash table. It has room for as many different sets as it is made for, at most 2^31. It keeps
// the sets themselves, and so it never takes one for another.
template <std::size_t kSize>
class CountedSets {
 public:
  using Set = std::array<std::int32_t, kSize>;  // ascending, none negative
  struct Counted {
    Set set;
    std::int32_t more;  // how often
  };

  explicit CountedSets(std::size_t most)
      : table_(most + most / 3 + 1, Counted{{kNone}, 0}), room_(kLongest * table_.size()) {}

  // Where the search for a set begins.
  std::size_t home(const Set& set) const {
    std::uint64_t hash = 0;
    for (const std::int32_t v : set) {
      hash = (hash ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>((hash >> 32) * table_.size() >> 32);
  }
  // Begins to bring it into the cache.
  void prefetch(std::size_t home) const { __builtin_prefetch(&table_[home]); }

  // The set, if it is here, or else the free place for it. Requires: `home` is home(set), and there
  // is a free place.
  Counted& at(const Set& set, std::size_t home) {
    std::size_t place = home;
    while (table_[place].set != set && !is_free(table_[place])) {
      if (++place == table_.size()) place = 0;
      room_ -= room_ > 0 ? 1 : 0;
    }
    return table_[place];
  }
  static bool is_free(const Counted& one) { return one.set.front() == kNone; }

  // Do so many hashes collide that searches take far longer than they should? Then stop asking.
  bool is_crowded() const { return room_ == 0; }

  // Do both meshes list each set equally often?
  bool is_even() const {
    return std::all_of(table_.begin(), table_.end(), [](const auto& one) { return one.more == 0; });
  }

 private:
  static constexpr std::int32_t kNone = -1;
  static constexpr std::size_t kLongest = 32;  // places to pass, for each place

  std::vector<Counted> table_;
  std::size_t room_;  // for places passed
};

}  // namespace circumspect::check
