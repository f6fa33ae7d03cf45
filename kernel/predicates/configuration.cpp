#include "kernel/predicates/configuration.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "kernel/exact/interruption.hpp"

namespace circumspect {
namespace {

// The order of the canonical perturbation: lexicographic by coordinates.
template <class IsBefore>
std::vector<std::size_t> ranks_by(std::size_t points, const IsBefore& is_before) {
  std::vector<std::size_t> order(points);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    end_if_interrupted();
    return is_before(a, b);
  });
  std::vector<std::size_t> ranks(points);
  for (std::size_t place = 0; place < order.size(); ++place) ranks[order[place]] = place;
  return ranks;
}

// The numbers divided by the least power of two that makes all of them fit a word, rounded down:
// they keep their order, except that some become equal.
std::vector<long> leading_words(const std::vector<Integer>& numbers) {
  std::size_t bits = 0;
  for (const Integer& number : numbers) bits = std::max(bits, bit_length(number));
  const std::size_t dropped = bits - std::min<std::size_t>(bits, std::numeric_limits<long>::digits);
  std::vector<long> words;
  words.reserve(numbers.size());
  Integer word;
  for (const Integer& number : numbers) {
    word = number >> dropped;
    words.push_back(word.get_si());
  }
  return words;
}

}  // namespace

Configuration::Configuration(const std::vector<Point>& points, const std::vector<Rational>& weights)
    : ambient_dimension_(points.empty() ? 0 : points.front().size()), hull_(affine_hull(points)) {
  assert(weights.empty() || weights.size() == points.size());
  choose_denominators(points, weights);
  scale_to_integers(points, weights);
  if (!has_common_denominator_) {
    ranks_ = ranks_by(points.size(),
                      [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
    return;
  }
  // With one common denominator, numerators are in the order of the coordinates, and their leading
  // bits distinguish almost all points.
  const auto d = static_cast<std::ptrdiff_t>(ambient_dimension_);
  const std::vector<long> leading = leading_words(numerators_);
  const auto at = [&](std::size_t v) {
    return numerators_.begin() + static_cast<std::ptrdiff_t>(v) * d;
  };
  ranks_ = ranks_by(points.size(), [&](std::size_t a, std::size_t b) {
    const long of_a = leading[a * ambient_dimension_], of_b = leading[b * ambient_dimension_];
    if (of_a != of_b) return of_a < of_b;
    return std::lexicographical_compare(at(a), at(a) + d, at(b), at(b) + d);
  });
}

void Configuration::choose_denominators(const std::vector<Point>& points,
                                        const std::vector<Rational>& weights) {
  denominators_.assign(points.size(), Integer(1));
  Integer common = 1;
  for (std::size_t v = 0; v < points.size(); ++v) {
    end_if_interrupted();
    Integer& own = denominators_[v];
    own = common_denominator(points[v]);
    if (!weights.empty()) own = common_denominator({&weights[v], 1}, own);
    if (!has_common_denominator_) continue;
    common = least_common_multiple(common, own);
    has_common_denominator_ = bit_length(common) <= kLargestCommonScale;
  }
  if (has_common_denominator_) denominators_.assign(points.size(), common);
}

void Configuration::scale_to_integers(const std::vector<Point>& points,
                                      const std::vector<Rational>& weights) {
  numerators_.reserve(points.size() * ambient_dimension_);
  heights_.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    end_if_interrupted();
    const Integer& denominator = denominators_[v];
    Integer height = 0;
    for (const Rational& x : points[v]) {
      const Integer numerator = numerator_over(denominator, x);
      height += numerator * numerator;
      numerators_.push_back(numerator);
    }
    if (!weights.empty()) height -= numerator_over(denominator, weights[v]) * denominator;
    heights_.push_back(height);
  }
}

}  // namespace circumspect
