#include "reference/kernel/predicates/configuration.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace circumspect {
namespace {

// The order of the canonical perturbation: lexicographic by coordinates.
std::vector<std::size_t> lexicographic_ranks(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> ranks(points.size());
  for (std::size_t place = 0; place < order.size(); ++place) ranks[order[place]] = place;
  return ranks;
}

// value · scale, which is known to be an integer.
Integer scaled(const Rational& value, const Integer& scale) {
  return value.get_num() * exact_quotient(scale, value.get_den());
}

}  // namespace

Configuration::Configuration(const std::vector<Point>& points, const std::vector<Rational>& weights)
    : ambient_dimension_(points.empty() ? 0 : points.front().size()),
      hull_(affine_hull(points)),
      ranks_(lexicographic_ranks(points)) {
  assert(weights.empty() || weights.size() == points.size());
  choose_denominators(points, weights);
  scale_to_integers(points, weights);
}

void Configuration::choose_denominators(const std::vector<Point>& points,
                                        const std::vector<Rational>& weights) {
  denominators_.assign(points.size(), Integer(1));
  Integer common = 1;
  for (std::size_t v = 0; v < points.size(); ++v) {
    Integer& own = denominators_[v];
    for (const Rational& x : points[v]) own = least_common_multiple(own, x.get_den());
    if (!weights.empty()) own = least_common_multiple(own, weights[v].get_den());
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
    const Integer& denominator = denominators_[v];
    Integer height = 0;
    for (const Rational& x : points[v]) {
      const Integer numerator = scaled(x, denominator);
      height += numerator * numerator;
      numerators_.push_back(numerator);
    }
    if (!weights.empty()) height -= scaled(weights[v], denominator) * denominator;
    heights_.push_back(height);
  }
}

}  // namespace circumspect
