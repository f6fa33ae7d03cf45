// Are numbers finite?
#pragma once

#include <atomic>
#include <span>

#include "oracle/judge/fast/in_chunks.hpp"

namespace circumspect::fast {

inline bool are_finite(std::span<const double> numbers, unsigned threads) {
  constexpr std::size_t kChunk = std::size_t{1} << 15;
  std::atomic<bool> finite = true;
  in_chunks(numbers.size(), kChunk, threads, [&](std::size_t, std::size_t first, std::size_t last) {
    // The sum of the products with 0 is 0, unless one of them is NaN: no branch.
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += numbers[i] * 0;
    if (sum != 0) finite.store(false, std::memory_order_relaxed);
  });
  return finite.load(std::memory_order_relaxed);
}

}  // namespace circumspect::fast
