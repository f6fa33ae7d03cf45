#include "construct/insertion_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace circumspect::construct {
namespace {

using GridCell = std::array<std::uint32_t, 3>;  // in the plane, the third is not used

// The random bits of a vertex (the function `mix` of SplitMix64).
std::uint64_t random_bits(std::uint64_t v) {
  v = (v + 1) * 0x9e3779b97f4a7c15;
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9;
  v = (v ^ (v >> 27)) * 0x94d049bb133111eb;
  return v ^ (v >> 31);
}

// Coordinate x of each point becomes the number of smaller coordinates on its axis, without its
// lowest bits if there are too many.
std::vector<GridCell> grid_cells(std::span<const double> coordinates, std::size_t dimension,
                                 int dropped) {
  const std::size_t count = coordinates.size() / dimension;
  std::vector<GridCell> cells(count);
  std::vector<std::pair<double, std::int32_t>> along(count);
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    for (std::size_t v = 0; v < count; ++v) {
      along[v] = {coordinates[v * dimension + axis], static_cast<std::int32_t>(v)};
    }
    std::sort(along.begin(), along.end());
    std::size_t smaller = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (along[i].first != along[smaller].first) smaller = i;
      cells[static_cast<std::size_t>(along[i].second)][axis] =
          static_cast<std::uint32_t>(smaller >> dropped);
    }
  }
  return cells;
}

// The place of a cell on the Hilbert curve of the grid {0, …, 2^bits − 1}^dimension (J. Skilling,
// Programming the Hilbert curve, AIP Conf. Proc. 707, 2004). Requires: dimension · bits <= 64.
std::uint64_t place_on_curve(GridCell cell, std::size_t dimension, int bits) {
  for (std::uint32_t bit = std::uint32_t{1} << (bits - 1); bit > 1; bit >>= 1) {
    const std::uint32_t lower = bit - 1;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      if (cell[axis] & bit) {
        cell[0] ^= lower;
      } else {
        const std::uint32_t exchanged = (cell[0] ^ cell[axis]) & lower;
        cell[0] ^= exchanged;
        cell[axis] ^= exchanged;
      }
    }
  }
  for (std::size_t axis = 1; axis < dimension; ++axis) cell[axis] ^= cell[axis - 1];
  std::uint32_t gray = 0;
  for (std::uint32_t bit = std::uint32_t{1} << (bits - 1); bit > 1; bit >>= 1) {
    if (cell[dimension - 1] & bit) gray ^= bit - 1;
  }
  std::uint64_t place = 0;
  for (int bit = bits - 1; bit >= 0; --bit) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      place = place << 1 | ((cell[axis] ^ gray) >> bit & 1);
    }
  }
  return place;
}

}  // namespace

std::vector<std::int32_t> insertion_order(std::span<const double> coordinates,
                                          std::size_t dimension) {
  const std::size_t count = coordinates.size() / dimension;
  const int wide = std::max(1, static_cast<int>(std::bit_width(count)));
  const int bits = std::min(wide, dimension == 2 ? 31 : 21);
  const std::vector<GridCell> cells = grid_cells(coordinates, dimension, wide - bits);
  // The final round, 0, has each point with probability 1/2; the first has about fifty.
  const int first_round = std::max(0, wide - 6);
  struct Turn {
    int round;
    std::uint64_t place;
    std::int32_t vertex;
  };
  std::vector<Turn> turns(count);
  for (std::size_t v = 0; v < count; ++v) {
    turns[v] = {std::min(first_round, std::countr_zero(random_bits(v))),
                place_on_curve(cells[v], dimension, bits), static_cast<std::int32_t>(v)};
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    if (a.round != b.round) return a.round > b.round;
    return a.place != b.place ? a.place < b.place : a.vertex < b.vertex;
  });
  std::vector<std::int32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = turns[i].vertex;
  return order;
}

}  // namespace circumspect::construct
