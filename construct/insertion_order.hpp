// A biased randomized insertion order, each round along a Hilbert curve. Book: Section 5.3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace circumspect::construct {

// All points, each once; the same order for the same numbers on every machine. The curve runs
// through the grid whose lines are the coordinates that occur, so that it is as good for points
// whose coordinates differ by hundreds of orders of magnitude. Requires: whole points, finite, of
// dimension 2 or 3, fewer than 2^31 of them.
std::vector<std::int32_t> insertion_order(std::span<const double> coordinates,
                                          std::size_t dimension);

}  // namespace circumspect::construct
