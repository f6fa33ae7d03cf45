#include "inputs/modifiers.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

const PointsCase& some_set() {
  static const PointsCase set{
      {{Rational(1), Rational(1) / 3}, {Rational(0), Rational(8)}, {Rational(-3), Rational(5)}},
      {Rational(1), Rational(2), Rational(-1) / 4}};
  return set;
}

// The modification of this set by a seed.
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

TEST_CASE("magnitudes: a set is brought within exponents, by a power of two where that does it") {
  const PointsCase far{
      {{power_of_two(200), Rational(0)}, {3 * power_of_two(190), power_of_two(180)}},
      {power_of_two(300), Rational(0)}};
  CHECK(!lie_within(far, {-100, 100}));
  const PointsCase near = brought_within(far, {-100, 100}, false);
  CHECK(lie_within(near, {-100, 100}));
  CHECK(near.points[0][0] == power_of_two(99));
  CHECK(near.points[1] == Point{3 * power_of_two(89), power_of_two(79)});
  CHECK(near.weights == std::vector<Rational>{power_of_two(98), Rational(0)});
  CHECK(brought_within(near, {-100, 100}, false).points == near.points);
  const PointsCase small{{{power_of_two(-1000)}, {3 * power_of_two(-1000)}}, {}};
  CHECK(lie_within(brought_within(small, {-100, 100}, false), {-100, 100}));
  CHECK(brought_within(small, {-100, 100}, false).points[1][0] == 3 * power_of_two(-100));
}

TEST_CASE(
    "magnitudes: exponents too far apart are moved together, and keep their order and their "
    "digits") {
  const PointsCase wide{{{power_of_two(-900)},
                         {5 * power_of_two(-300)},
                         {Rational(0)},
                         {Rational(-7)},
                         {power_of_two(800)}},
                        {}};
  const PointsCase near = brought_within(wide, {-20, 20}, false);
  REQUIRE(near.points.size() == 5);
  CHECK(lie_within(near, {-20, 20}));
  CHECK(near.points[2][0] == 0);
  CHECK(near.points[0][0] < near.points[1][0]);
  CHECK(near.points[1][0] < near.points[4][0]);
  CHECK(near.points[1][0].get_num() % 5 == 0);
  CHECK(near.points[3][0].get_num() % 7 == 0);
}

TEST_CASE("magnitudes: integers of so many bits, and what is of such stays as it is") {
  const PointsCase set{{{Rational(-5), Rational(100)}, {Rational(0), Rational(3)}}, {}};
  CHECK(in_integers(set, 7, false).points == set.points);
  const PointsCase rounded = in_integers(
      {{{Rational(1) / 4, Rational(-1)}, {Rational(0), Rational(1) / 4}}, {}}, 1, false);
  CHECK(rounded.points == std::vector<Point>{{0, -1}, {0, 0}});
  for (const Point& point :
       in_integers({{{exact_value(0.1), exact_value(1e300)}, {exact_value(1e-300), 1}}, {}}, 20,
                   false)
           .points) {
    for (const Rational& x : point) {
      CHECK(x.get_den() == 1);
      CHECK(abs(x) <= power_of_two(20));
    }
  }
}

}  // namespace
}  // namespace circumspect::generators
