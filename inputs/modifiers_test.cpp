#include "inputs/modifiers.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"

namespace circumspect::generators {
namespace {

const PointsCase& some_set() {
  static const PointsCase set{
      {{Rational(1), Rational(1) / 3}, {Rational(0), Rational(8)}, {Rational(-3), Rational(5)}},
      {Rational(1), Rational(2), Rational(-1) / 4}};
  return set;
}

// The set that a seed makes of this one.
template <class Modifier>
PointsCase changed(const Modifier& modifier, const PointsCase& set, std::uint64_t seed,
                   bool may_repeat_points = false) {
  Dice dice(seed);
  return modifier(dice, set, may_repeat_points);
}

TEST_CASE("ulp: coordinates one ulp from the rounded ones at most, some of them moved, 0 too") {
  const PointsCase rounded = in_doubles(some_set());
  std::set<double> images_of_zero;
  std::size_t moved = 0, all = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const PointsCase near = changed(one_ulp_away, some_set(), seed);
    REQUIRE(near.points.size() == 3);
    CHECK(near.weights == rounded.weights);
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t i = 0; i < 2; ++i) {
        const double before = rounded.points[v][i].get_d(), after = near.points[v][i].get_d();
        CHECK(exact_value(after) == near.points[v][i]);
        ++all;
        moved += before == after ? 0 : 1;
        if (before == 0) {
          images_of_zero.insert(after);
        } else {
          const bool is_near = after == before || after == std::nextafter(before, HUGE_VAL) ||
                               after == std::nextafter(before, -HUGE_VAL);
          CHECK(is_near);
        }
      }
    }
  }
  // An ulp of 8 is 2^-49.
  CHECK(images_of_zero == std::set<double>{-0x1p-49, 0.0, 0x1p-49});
  CHECK(moved * 3 > all);
  CHECK(moved * 3 < 2 * all);
}

TEST_CASE("ulp: points that become equal become one, unless they may be equal") {
  const PointsCase pair{{{Rational(1)}, {exact_value(1.0 + 0x1p-52)}}};
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    sizes.insert(changed(one_ulp_away, pair, seed).points.size());
    CHECK(changed(one_ulp_away, pair, seed, true).points.size() == 2);
  }
  CHECK(sizes == std::set<std::size_t>{1, 2});
}

TEST_CASE("scaled: one power of two for all points, and its square for the weights") {
  std::set<Rational> factors;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PointsCase set = changed(scaled_by_power_of_two, some_set(), seed);
    const Rational factor = set.points[0][0];
    factors.insert(factor);
    int exponent = 0;
    CHECK(std::frexp(factor.get_d(), &exponent) == 0.5);
    CHECK(std::abs(exponent - 1) <= 300);
    for (std::size_t v = 0; v < 3; ++v) {
      CHECK(set.points[v] == factor * some_set().points[v]);
      CHECK(set.weights[v] == factor * factor * some_set().weights[v]);
    }
  }
  CHECK(factors.size() > 20);
}

TEST_CASE("scaled: nothing leaves the range of doubles") {
  const PointsCase wide{{{exact_value(0x1p990)}, {exact_value(0x1p-990)}}};
  const PointsCase high{{{exact_value(0x1p990)}}};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto scaled = [seed](const PointsCase& set) {
      return changed(scaled_by_power_of_two, set, seed);
    };
    CHECK(in_doubles(scaled(wide)).points == scaled(wide).points);
    CHECK(scaled(high).points[0][0] <= exact_value(0x1p1000));
  }
}

TEST_CASE("moved: by one vector, then rounded; integers near enough stay exact") {
  std::size_t exact = 0, rounded = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const PointsCase set = changed(far_from_origin, some_set(), seed);
    CHECK(in_doubles(set).points == set.points);
    if (set.points.size() < 3) continue;
    const Point difference = set.points[2] - set.points[1];
    (difference == Point{Rational(-3), Rational(-3)} ? exact : rounded) += 1;
  }
  CHECK(exact > 10);
  CHECK(exact + rounded > 30);
}

}  // namespace
}  // namespace circumspect::generators
