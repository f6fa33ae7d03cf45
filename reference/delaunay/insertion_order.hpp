// The order in which incremental insertion takes the vertices. Book: Section 5.3.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/complex/point_set.hpp"
#include "reference/delaunay/space_filling_curve.hpp"

namespace circumspect::delaunay {

enum class InsertionOrder {
  kAsGiven,      // by index
  kRandom,       // a uniformly random permutation
  kBrioHilbert,  // a biased randomized insertion order, each round along a Hilbert curve
  kBrioZOrder,   // the same along a z-order curve
};

// All vertices, each once. The same seed gives the same order on every machine.
std::vector<Vertex> insertion_order(const PointSet& points, InsertionOrder order,
                                    std::uint64_t seed);

// 0, …, count − 1 in a uniformly random order.
std::vector<Vertex> random_permutation(std::size_t count, std::uint64_t seed);

// The rounds of a BRIO on n vertices, numbered zero through ⌈log₂ n⌉: each vertex is in the final
// round with probability 1/2, the remaining ones in the second-last with probability 1/2, and so
// on; round zero takes what is left. Each round ascending.
std::vector<std::vector<Vertex>> brio_rounds(std::size_t count, std::uint64_t seed);

}  // namespace circumspect::delaunay
