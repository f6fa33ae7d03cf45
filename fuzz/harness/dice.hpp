// Random numbers that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "inputs/mixed.hpp"

namespace circumspect::harness {

// Splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    const std::uint64_t bits = generators::mixed(state_);
    state_ += generators::kMixingStep;
    return bits;
  }
  // In [0, count). Requires: count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
  // In [first, last]. Requires: first <= last.
  int within(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::size_t>(last - first) + 1));
  }

 private:
  std::uint64_t state_;
};

}  // namespace circumspect::harness
