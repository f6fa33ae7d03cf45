// The source of all randomness: numbers that follow from a seed, the same on every machine.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace circumspect::generators {

// What `mixed` adds before it mixes: the step of splitmix64.
inline constexpr std::uint64_t kMixingStep = 0x9e3779b97f4a7c15U;

// One step of splitmix64, a bijection that maps neighbouring numbers to unrelated ones (Steele, Lea
// and Flood, "Fast splittable pseudorandom number generators", 2014).
constexpr std::uint64_t mixed(std::uint64_t value) {
  value += kMixingStep;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

// Splitmix64: 2^64 throws before they repeat, the k-th of them mixed(seed + k · kMixingStep), k
// from 0. The distributions of the standard library are not used anywhere, because their results
// for equal bits differ between libraries. Two throws within one expression have no order in C++,
// so each is in a statement of its own, or within the braces of a list.
class Dice {
 public:
  explicit constexpr Dice(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t bits() {
    const std::uint64_t bits = mixed(state_);
    state_ += kMixingStep;
    return bits;
  }

  // Uniform in [0, count), exactly: 2^64 mod count of the possible throws are rejected and thrown
  // again. Requires: count > 0.
  constexpr std::size_t below(std::size_t count) {
    const std::uint64_t least = (0 - std::uint64_t{count}) % count;
    std::uint64_t thrown = bits();
    while (thrown < least) thrown = bits();
    return static_cast<std::size_t>(thrown % count);
  }

  // Uniform in [first, last]. Requires: first <= last, fewer than 2^64 − 1 apart.
  template <std::signed_integral Number>
  constexpr Number within(Number first, Number last) {
    // Without signs, since the distance need not be a Number.
    const std::size_t from = static_cast<std::size_t>(first);
    return static_cast<Number>(from + below(static_cast<std::size_t>(last) - from + 1));
  }

 private:
  std::uint64_t state_;
};

// Puts a list in another order, each as likely as any other.
template <class List>
constexpr void shuffle(List& list, Dice& dice) {
  for (std::size_t left = list.size(); left > 1; --left) {
    std::swap(list[left - 1], list[dice.below(left)]);
  }
}

}  // namespace circumspect::generators
