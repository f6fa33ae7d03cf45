// Which points are vertices: one bit each, set by any number of threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace circumspect::fast {

class UsedPoints {
 public:
  explicit UsedPoints(std::size_t points) : points_(points), words_((points + 63) / 64) {}

  // Requires: v < the number of points.
  void mark(std::size_t v) {
    std::atomic<std::uint64_t>& word = words_[v / 64];
    const std::uint64_t bit = std::uint64_t{1} << (v % 64);
    // Most points are marked before, and reading a shared word is cheap.
    if ((word.load(std::memory_order_relaxed) & bit) == 0) {
      word.fetch_or(bit, std::memory_order_relaxed);
    }
  }

  // The points that are not marked, ascending.
  std::vector<std::size_t> missing() const {
    std::vector<std::size_t> unused;
    for (std::size_t place = 0; place < words_.size(); ++place) {
      const std::uint64_t word = words_[place].load(std::memory_order_relaxed);
      if (word == ~std::uint64_t{0}) continue;
      for (std::size_t v = place * 64; v < points_ && v < (place + 1) * 64; ++v) {
        if ((word >> (v % 64) & 1) == 0) unused.push_back(v);
      }
    }
    return unused;
  }

 private:
  std::size_t points_;
  std::vector<std::atomic<std::uint64_t>> words_;
};

}  // namespace circumspect::fast
