#include "reference/delaunay/insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>
#include <utility>

namespace circumspect::delaunay {
namespace {

// A number below `bound`, all equally likely. The standard fixes what the engine returns, but not
// what its distributions and its shuffle make of that.
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
