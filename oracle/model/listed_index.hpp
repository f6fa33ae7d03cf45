// Indices as users list them, and places from 0. All of this is modulo 2^64: then every index of 64 bits
// has a place of its own, comes back from it as it was listed, and has the place of a point only if it
// names one. What goes round at the ends names no point, since the indices of all points fit 64 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "reference/kernel/predicates/configuration.hpp"

namespace circumspect {

static_assert(sizeof(Vertex) == sizeof(std::uint64_t));

// The place of what a user calls `index` and counts from `first_index`.
constexpr Vertex place_of_index(Vertex index, Vertex first_index) {
  return static_cast<Vertex>(static_cast<std::uint64_t>(index) -
                             static_cast<std::uint64_t>(first_index));
}

// What a user calls the thing at a place.
constexpr Vertex index_of_place(Vertex place, Vertex first_index) {
  return static_cast<Vertex>(static_cast<std::uint64_t>(place) +
                             static_cast<std::uint64_t>(first_index));
}

// Do the indices of so many things, counted from `first_index`, fit 64 bits?
constexpr bool has_room(Vertex first_index, std::size_t count) {
  const std::uint64_t after_first = static_cast<std::uint64_t>(std::numeric_limits<Vertex>::max()) -
                                    static_cast<std::uint64_t>(first_index);
  return count == 0 || count - 1 <= after_first;
}

}  // namespace circumspect
