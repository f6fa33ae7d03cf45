#include "reference/delaunay/triggers.hpp"

#include <cstdint>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "reference/delaunay/dictionary.hpp"

namespace circumspect::delaunay {

Simplex stoppers(const PointSet& points, const Simplex& simplex) {
  Simplex contained;
  for (Vertex q = 0; points.names(q); ++q) {
    if (contains(simplex, q)) continue;
    if (perturbed_in_ball(points.configuration(), simplex, q) > 0) contained.push_back(q);
  }
  return contained;
}

std::vector<std::uint64_t> numbers_of_j_simplices(const PointSet& points) {
  if (points.empty()) return {};
  const auto triggers = static_cast<std::size_t>(points.dimension() + 1);
  std::vector<std::uint64_t> numbers(points.size() - triggers + 1);
  Simplex subset = first_subset(triggers);
  do {
    if (orientation(points.configuration(), subset) == 0) continue;
    ++numbers[stoppers(points, subset).size()];
  } while (next_subset(subset, points.size()));
  return numbers;
}

Integer binomial(std::uint64_t n, std::uint64_t m) {
  if (m > n) return 0;
  Integer result = 1;
  for (std::uint64_t i = 1; i <= m; ++i) {
    result *= to_integer(n - m + i);
    result /= to_integer(i);  // leaves no remainder: it has i consecutive factors
  }
  return result;
}

Rational probability_in_random_order(int dimension, std::uint64_t j) {
  const auto triggers = static_cast<std::uint64_t>(dimension + 1);
  return Rational(1, binomial(j + triggers, triggers));
}

Rational bound_in_brio(int dimension, std::uint64_t j) {
  Integer numerator = 1;
  Integer denominator = 1;
  for (int i = 1; i <= dimension + 1; ++i) {
    numerator *= 2 * i;
    denominator *= to_integer(j);
  }
  numerator += 1;
  if (denominator <= numerator) return 1;
  Rational bound(numerator, denominator);
  bound.canonicalize();
  return bound;
}

Expectation expectation(int dimension, const std::vector<std::uint64_t>& numbers,
                        Rational (*probability)(int dimension, std::uint64_t j)) {
  Expectation sum;
  for (std::uint64_t j = 0; j < numbers.size(); ++j) {
    const Rational created = probability(dimension, j) * Rational(to_integer(numbers[j]));
    sum.simplices += created;
    sum.conflicts += Rational(to_integer(j)) * created;
  }
  return sum;
}

}  // namespace circumspect::delaunay
