// Random numbers that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace circumspect::harness {

// Splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
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
