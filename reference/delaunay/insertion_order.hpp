// Orders of insertion: biased randomized insertion orders, along space-filling curves. Book:
// Section 5.3.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect::delaunay {

// A cell of the grid {0, …, 2^bits − 1}^k.
using GridCell = std::vector<std::uint64_t>;

// Does the z-order curve visit cell a before cell b? It orders cells by the number that interleaves
// the bits of their coordinates.
bool precedes_on_z_order_curve(const GridCell& a, const GridCell& b);

// The cell whose place on the z-order curve is the place of `cell` on the Hilbert curve of the grid
// (J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707, 2004). Consecutive cells of the
// Hilbert curve share a facet. Requires: every coordinate below 2^bits, 1 ≤ bits ≤ 63.
GridCell from_hilbert_to_z_order(GridCell cell, int bits);

enum class SpaceFillingCurve { kHilbert, kZOrder };

// The vertices in the order in which the curve meets them. The curve runs through the grid whose
// lines are the coordinates that occur, on the axes of the set's affine hull: coordinate x becomes
// the number of smaller coordinates on its axis. So the order is exact and does not depend on how
// evenly the points are spread. Requires: the set names the vertices, and each has a cell of its
// own, as points of a set have.
std::vector<Vertex> along_curve(const PointSet& points, std::vector<Vertex> vertices,
                                SpaceFillingCurve curve);

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
