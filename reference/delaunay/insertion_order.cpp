#include "reference/delaunay/insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>
#include <utility>

#include "kernel/exact/interruption.hpp"

namespace circumspect::delaunay {

namespace {

// Replaces the coordinates of the vertices on one axis by how many different ones are smaller.
void number_coordinates(const PointSet& points, const std::vector<Vertex>& vertices,
                        std::size_t axis, std::size_t place, std::vector<GridCell>& cells) {
  const auto coordinate = [&](std::size_t i) -> const Rational& {
    return points[vertices[i]][axis];
  };
  std::vector<std::size_t> order(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    end_if_interrupted();
    return coordinate(a) < coordinate(b);
  });
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && coordinate(order[i - 1]) != coordinate(order[i])) ++number;
    cells[order[i]][place] = number;
  }
}

}  // namespace

bool precedes_on_z_order_curve(const GridCell& a, const GridCell& b) {
  // The most significant bit in which the cells differ decides; among axes that differ in it, the
  // first.
  std::size_t deciding = 0;
  std::uint64_t largest = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    const std::uint64_t difference = a[axis] ^ b[axis];
    if (std::bit_width(largest) < std::bit_width(difference)) {
      deciding = axis;
      largest = difference;
    }
  }
  return a[deciding] < b[deciding];
}

GridCell from_hilbert_to_z_order(GridCell cell, int bits) {
  const std::uint64_t top = std::uint64_t{1} << (bits - 1);
  // From the largest subcubes to the smallest, undo the reflection or the exchange of axes with
  // which the curve passes through the subcube.
  for (std::uint64_t bit = top; bit > 1; bit >>= 1) {
    const std::uint64_t lower_bits = bit - 1;
    for (std::uint64_t& x : cell) {
      if ((x & bit) != 0) {
        cell[0] ^= lower_bits;
      } else {
        const std::uint64_t exchanged = (cell[0] ^ x) & lower_bits;
        cell[0] ^= exchanged;
        x ^= exchanged;
      }
    }
  }
  // Within one subcube the curve goes through the corners in the order of the Gray code.
  for (std::size_t axis = 1; axis < cell.size(); ++axis) cell[axis] ^= cell[axis - 1];
  std::uint64_t carried = 0;
  for (std::uint64_t bit = top; bit > 1; bit >>= 1) {
    if ((cell.back() & bit) != 0) carried ^= bit - 1;
  }
  for (std::uint64_t& x : cell) x ^= carried;
  return cell;
}

std::vector<Vertex> along_curve(const PointSet& points, std::vector<Vertex> vertices,
                                SpaceFillingCurve curve) {
  if (points.dimension() < 1) return vertices;
  const std::span<const std::size_t> axes = points.configuration().axes();
  std::vector<GridCell> cells(vertices.size(), GridCell(axes.size()));
  for (std::size_t place = 0; place < axes.size(); ++place) {
    number_coordinates(points, vertices, axes[place], place, cells);
  }
  if (curve == SpaceFillingCurve::kHilbert) {
    const int bits = std::max(1, static_cast<int>(std::bit_width(vertices.size())));
    for (GridCell& cell : cells) cell = from_hilbert_to_z_order(std::move(cell), bits);
  }
  std::vector<std::size_t> order(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    end_if_interrupted();
    return precedes_on_z_order_curve(cells[a], cells[b]);
  });
  std::vector<Vertex> sequence;
  sequence.reserve(order.size());
  for (const std::size_t i : order) sequence.push_back(vertices[i]);
  return sequence;
}

namespace {

// A number below `bound`, all equally likely. The standard defines the results of the engine, but
// not those of its distributions and its shuffle.
std::uint64_t random_below(std::uint64_t bound, std::mt19937_64& engine) {
  const std::uint64_t remainder = (UINT64_MAX % bound + 1) % bound;  // 2^64 mod bound
  std::uint64_t number = engine();
  while (number > UINT64_MAX - remainder) number = engine();
  return number % bound;
}

std::vector<Vertex> brio(const PointSet& points, SpaceFillingCurve curve, std::uint64_t seed) {
  std::vector<Vertex> sequence;
  const std::vector<std::vector<Vertex>> rounds = brio_rounds(points.size(), seed);
  for (std::size_t round = 0; round < rounds.size(); ++round) {
    std::vector<Vertex> part = along_curve(points, rounds[round], curve);
    // "Reversed on even-numbered rounds, so each round begins near where the previous round ends"
    // (Section 5.5).
    if (round % 2 == 0) std::reverse(part.begin(), part.end());
    sequence.insert(sequence.end(), part.begin(), part.end());
  }
  return sequence;
}

}  // namespace

std::vector<Vertex> random_permutation(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<Vertex> sequence(count);
  std::iota(sequence.begin(), sequence.end(), Vertex{0});
  for (std::size_t i = count; i > 1; --i) {
    std::swap(sequence[i - 1], sequence[random_below(i, engine)]);
  }
  return sequence;
}

std::vector<std::vector<Vertex>> brio_rounds(std::size_t count, std::uint64_t seed) {
  if (count == 0) return {};
  std::mt19937_64 engine(seed);
  const auto last = static_cast<std::size_t>(std::bit_width(count - 1));  // ⌈log₂ count⌉
  std::vector<std::vector<Vertex>> rounds(last + 1);
  for (std::size_t v = 0; v < count; ++v) {
    std::size_t round = last;
    while (round > 0 && random_below(2, engine) == 0) --round;
    rounds[round].push_back(static_cast<Vertex>(v));
  }
  return rounds;
}

std::vector<Vertex> insertion_order(const PointSet& points, InsertionOrder order,
                                    std::uint64_t seed) {
  switch (order) {
    case InsertionOrder::kRandom:
      return random_permutation(points.size(), seed);
    case InsertionOrder::kBrioHilbert:
      return brio(points, SpaceFillingCurve::kHilbert, seed);
    case InsertionOrder::kBrioZOrder:
      return brio(points, SpaceFillingCurve::kZOrder, seed);
    case InsertionOrder::kAsGiven:
      break;
  }
  std::vector<Vertex> sequence(points.size());
  std::iota(sequence.begin(), sequence.end(), Vertex{0});
  return sequence;
}

}  // namespace circumspect::delaunay
