// Numbers that look random, made of numbers that do not: for seeds.
#pragma once

#include <cstdint>

namespace circumspect::generators {

// What `mixed` adds before it mixes: the step of splitmix64.
inline constexpr std::uint64_t kMixingStep = 0x9e3779b97f4a7c15U;

// One step of splitmix64, a bijection: equal numbers, equal results; neighbours, unrelated ones (Steele, Lea
// and Flood, "Fast splittable pseudorandom number generators", 2014).
constexpr std::uint64_t mixed(std::uint64_t value) {
  value += kMixingStep;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

}  // namespace circumspect::generators
