// What every family must do: sets of the right size and dimension, the same for a seed, that
// shrink.
#include "inputs/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "inputs/arrangement.hpp"
#include "inputs/cases.hpp"
#include "inputs/complex_families.hpp"
#include "inputs/dice.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/untidy.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "properties/arguments/generated.hpp"

namespace circumspect::generators {

namespace {

constexpr std::size_t kPoints = 12;

std::string text(const PointsCase& set) {
  std::ostringstream out;
  out << set;
  return out.str();
}

// Calls look(family, dimension, set) for some sets of each family.
template <typename Look>
void for_each_set(const std::vector<Family>& all, int seeds, const Look& look) {
  for (const Family& family : all) {
    CAPTURE(family.name);
    for (std::size_t dimension = 1; dimension <= 4; ++dimension) {
      if (!family.exists_in(dimension)) continue;
      CAPTURE(dimension);
      for (int seed = 0; seed < seeds; ++seed) {
        CAPTURE(seed);
        look(family, dimension,
             drawn(family, dimension, {kPoints}, static_cast<std::uint64_t>(seed)));
      }
    }
  }
}

bool has_equal_points(const PointsCase& set) {
  return std::set<Point>(set.points.begin(), set.points.end()).size() < set.points.size();
}

TEST_CASE("families: as many points as allowed, of the dimension, with weights if weighted") {
  for_each_set(modified_families(), 6,
               [](const Family& family, std::size_t dimension, const PointsCase& set) {
                 CHECK(set.points.size() <= kPoints);
                 for (const Point& point : set.points) CHECK(point.size() == dimension);
                 CHECK(set.weights.size() == (family.weighted ? set.points.size() : 0));
               });
}

TEST_CASE("families: equal points only where the table says so, and there indeed") {
  for_each_set(modified_families(), 6,
               [](const Family& family, std::size_t, const PointsCase& set) {
                 if (!family.repeats_points) CHECK_FALSE(has_equal_points(set));
               });
  const Family* family = find_family("duplicates");
  REQUIRE(family != nullptr);
  CHECK(family->repeats_points);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PointsCase set = drawn(*family, 3, {kPoints, true}, seed);
    CHECK(has_equal_points(set));
    CHECK(has_equal_points(in_doubles(set, true)));
    CHECK_FALSE(has_equal_points(in_doubles(set)));
    const PointsCase small = drawn(*family, 3, {4}, seed);
    if (small.points.size() > 1) CHECK(has_equal_points(small));
  }
}

TEST_CASE("families: the full size gives as many points as there are, or nearly") {
  for (const Family& family : families()) {
    CAPTURE(family.name);
    const std::size_t dimension = family.exists_in(2) ? 2 : 3;
    std::size_t largest = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const PointsCase set = drawn(family, dimension, {kPoints, true}, seed);
      largest = std::max(largest, set.points.size());
    }
    CHECK(largest >= 7);
  }
}

TEST_CASE("families: a seed stands for one set, another for another one") {
  for (const Family& family : modified_families()) {
    CAPTURE(family.name);
    const std::size_t dimension = family.exists_in(2) ? 2 : 3;
    std::set<std::string> different;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const std::string first = text(drawn(family, dimension, {kPoints}, seed));
      CHECK(first == text(drawn(family, dimension, {kPoints}, seed)));
      different.insert(first);
    }
    CHECK(different.size() >= 4);
  }
}

TEST_CASE("families: names are unique words, and are found") {
  std::set<std::string> names;
  for (const Family& family : modified_families()) {
    CHECK(names.insert(family.name).second);
    CHECK(family.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-+") == std::string::npos);
    CHECK(find_family(family.name) == &family);
    CHECK_FALSE(family.about.empty());
  }
  CHECK(names.size() == families().size() * (1 + family_modifiers().size()));
  CHECK(find_family("sphere") ==
        &modified_families()[static_cast<std::size_t>(
            std::find_if(families().begin(), families().end(),
                         [](const Family& family) { return family.name == "sphere"; }) -
            families().begin())]);
  CHECK(find_family("no-such-family") == nullptr);
  CHECK(find_family("sphere+") == nullptr);
}

// A failing set of a property is reduced to as few points as still fail, with small coordinates.
TEST_CASE("families: modifiers go together, one applied after the other") {
  const Family* const both = find_family("grid+moved+ulp");
  REQUIRE(both != nullptr);
  CHECK(both == find_family("grid+moved+ulp"));
  CHECK(both->name == "grid+moved+ulp");
  const PointsCase moved = drawn(*find_family("grid+moved"), 2, {9, true}, 7);
  CHECK(drawn(*both, 2, {9, true}, 7).points != moved.points);
  CHECK(drawn(*find_family("grid+ulp+moved"), 2, {9, true}, 7).points !=
        drawn(*both, 2, {9, true}, 7).points);
  for (const char* const none : {"grid+", "grid+moved+", "grid+moved+no", "no+ulp+moved", "+ulp"}) {
    CHECK(find_family(none) == nullptr);
  }
}

TEST_CASE("families: grids and cubes have as many points as are asked for") {
  for (const char* const name : {"grid", "cube"}) {
    for (const std::size_t dimension : {2, 3}) {
      CHECK(drawn(*find_family(name), dimension, {1000, true}, 1).points.size() > 400);
    }
  }
}

TEST_CASE("families: sets shrink to few points") {
  for (const std::string_view name : {"sphere", "pythagorean-sphere", "cubic-lattice+ulp",
                                      "submerged", "twisted-prism+moved", "huge+scaled"}) {
    CAPTURE(name);
    const Family* family = find_family(name);
    REQUIRE(family != nullptr);
    const rc::Gen<PointsCase> sets = generated([&](Dice& dice) {
      return family->draw(dice, 3, {kPoints, true});
    });
    rc::Shrinkable<PointsCase> shrunk = sets(rc::Random(4), rc::kNominalSize);
    for (std::uint64_t seed = 5; shrunk.value().points.size() < 8; ++seed) {
      shrunk = sets(rc::Random(seed), rc::kNominalSize);
    }
    const auto fails = [](const PointsCase& set) { return set.points.size() >= 5; };
    for (bool simpler = true; simpler;) {
      simpler = false;
      auto candidates = shrunk.shrinks();
      while (const auto candidate = candidates.next()) {
        if (!fails(candidate->value())) continue;
        shrunk = *candidate;
        simpler = true;
        break;
      }
    }
    CHECK(shrunk.value().points.size() == 5);
    for (const Point& point : shrunk.value().points) {
      for (const Rational& x : point) CHECK(abs(x) <= 4);
    }
  }
}

TEST_CASE("nearest_double: to nearest, ties to even, also among subnormal numbers") {
  const Rational ulp = exact_value(0x1p-52), least = exact_value(0x1p-1074);
  CHECK(nearest_double(1 + ulp / 2) == 1.0);
  CHECK(nearest_double(1 + 3 * ulp / 2) == 1.0 + 0x1p-51);
  CHECK(nearest_double(1 + ulp / 2 + exact_value(0x1p-200)) == 1.0 + 0x1p-52);
  CHECK(nearest_double(-1 - 3 * ulp / 4) == -1.0 - 0x1p-52);
  CHECK(nearest_double(Rational(1) / 3) == 1.0 / 3);
  CHECK(nearest_double(Rational(2) / 3) == 2.0 / 3);
  CHECK(nearest_double(Rational(1) / 10) == 0.1);
  CHECK(nearest_double(least / 2) == 0);
  CHECK(nearest_double(3 * least / 4) == 0x1p-1074);
  CHECK(nearest_double(-7 * least / 4) == -0x1p-1073);
  CHECK(nearest_double(Rational(0)) == 0);
}

TEST_CASE("in_doubles: every number a double, and arrays there and back") {
  for_each_set(modified_families(), 4,
               [](const Family& family, std::size_t dimension, const PointsCase& set) {
                 const PointsCase rounded = in_doubles(set, family.repeats_points);
                 const PointArray points = array(rounded, dimension);
                 CHECK(points.dimension == dimension);
                 CHECK(points.size() == rounded.points.size());
                 CHECK(std::all_of(points.coordinates.begin(), points.coordinates.end(),
                                   [](double x) { return std::isfinite(x); }));
                 const PointsCase back = from(points);
                 CHECK(back.points == rounded.points);
                 CHECK(back.weights == rounded.weights);
               });
}

}  // namespace

// ---- Families of complexes ----
namespace {

std::string text(const ComplexCase& made) {
  std::ostringstream out;
  out << made;
  return out.str();
}

TEST_CASE("families of domains: valid, of their dimension, also in doubles, the same for a seed") {
  for (const ComplexFamily& family : complex_families()) {
    CAPTURE(family.name);
    std::set<std::string> different;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      CAPTURE(seed);
      const ComplexCase made = drawn(family, 10, seed);
      CHECK(validated(made.input, 1));
      const ComplexCase rounded = in_doubles(made);
      CHECK(rounded.input.points == made.input.points);
      CHECK(validated(rounded.input, 1));
      for (const Point& point : made.input.points) CHECK(point.size() == family.dimension);
      CHECK(text(made) == text(drawn(family, 10, seed)));
      different.insert(text(made));
    }
    CHECK(different.size() >= 4);
  }
}

TEST_CASE("modifiers of domains: valid, of doubles, and mostly another domain") {
  std::size_t changed = 0, rounded_turns = 0, all = 0;
  for (const ComplexModifier& modifier : complex_modifiers()) {
    for (const ComplexFamily& plain : complex_families()) {
      const ComplexFamily family = modified(plain, modifier);
      CAPTURE(family.name);
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const ComplexCase made = drawn(family, 10, seed);
        CHECK(made.family == family.name);
        CHECK(validated(made.input, 1));
        CHECK(in_doubles(made).input.points == made.input.points);
        ++all;
        const bool is_another = made.input.points != drawn(plain, 10, seed).input.points;
        if (is_another) ++changed;
        const auto is_whole = [](const Point& point) {
          return std::all_of(point.begin(), point.end(),
                             [](const Rational& x) { return x.get_den() == 1; });
        };
        if (modifier.name == "rotated" &&
            !std::all_of(made.input.points.begin(), made.input.points.end(), is_whole)) {
          ++rounded_turns;
        }
      }
    }
  }
  CHECK(4 * changed > 3 * all);
  CHECK(rounded_turns > 3);
}

TEST_CASE("families of domains: what they are named for occurs") {
  std::size_t holes = 0, cavities = 0, slits = 0, lone_segments = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    for (const ComplexFamily& family : complex_families()) {
      if (family.name != "furnished-boxes" && family.name != "named-complexes") continue;
      const PiecewiseLinearInput input = drawn(family, 10, seed).input;
      for (const PolygonLines& polygon : input.polygons) {
        if (!polygon.hole_seeds.empty()) ++holes;
        if (polygon.lines.size() > 1) ++slits;
      }
      if (!input.hole_seeds.empty()) ++cavities;
      if (!input.segments.empty()) ++lone_segments;
    }
  }
  CHECK(holes > 0);
  CHECK(cavities > 0);
  CHECK(slits > 0);
  CHECK(lone_segments > 0);
}

}  // namespace

// ---- Untidy domains ----
namespace {

ComplexCase notched_square() {
  ComplexCase whole;
  whole.input.points = {{0, 0}, {8, 0}, {8, 8}, {4, 4}, {0, 8}};
  whole.input.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}};
  return whole;
}

// The first thing that is wrong with it; nothing if it is valid.
std::optional<BreachKind> breach(const PiecewiseLinearInput& input) {
  const auto valid = validated(input, 1);
  return valid ? std::nullopt : std::optional(valid.error().front().kind);
}

TEST_CASE("each kind of untidiness is what it says, and its arrangement is valid and of doubles") {
  const std::map<Untidiness, std::set<BreachKind>> expected = {
      {Untidiness::kTouching, {BreachKind::kVertexInSegment}},
      {Untidiness::kCrossing, {BreachKind::kVertexInSegment, BreachKind::kCrossingSegments}},
      {Untidiness::kOverlapping, {BreachKind::kVertexInSegment, BreachKind::kDuplicateVertex}},
      {Untidiness::kRepetition, {BreachKind::kDuplicateVertex}}};
  for (const auto& [untidiness, breaches] : expected) {
    const Untidiness kind = untidiness;
    std::set<BreachKind> met;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Dice dice(seed);
      const ComplexCase untidy = untidied(dice, notched_square(), {kind});
      CHECK(!breach(arranged(untidy.input)));
      if (const auto found = breach(untidy.input)) met.insert(*found);
    }
    CAPTURE(name(kind));
    for (const BreachKind one : breaches) CHECK(met.count(one) == 1);
  }
}

TEST_CASE("in space: each kind of untidiness, and an arrangement that is valid and of doubles") {
  const std::map<Untidiness, std::set<BreachKind>> expected = {
      {Untidiness::kTouching, {BreachKind::kVertexInSegment}},
      {Untidiness::kCrossing, {BreachKind::kCrossingSegments, BreachKind::kSegmentPiercesPolygon}},
      {Untidiness::kOverlapping, {BreachKind::kVertexInSegment, BreachKind::kDuplicateVertex}},
      {Untidiness::kRepetition, {BreachKind::kDuplicateVertex}}};
  // A tetrahedron with a slit in its floor.
  ComplexCase whole;
  whole.input.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {1, 1, 0}, {2, 1, 0}};
  whole.input.polygons = {
      {{{0, 1, 2}, {4, 5}}, {}}, {{{0, 1, 3}}, {}}, {{{0, 2, 3}}, {}}, {{{1, 2, 3}}, {}}};
  for (const auto& [untidiness, breaches] : expected) {
    const Untidiness kind = untidiness;
    std::set<BreachKind> met;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Dice dice(seed);
      const ComplexCase untidy = untidied(dice, whole, {kind});
      CHECK(untidy.input.polygons.size() == 4);
      const PiecewiseLinearInput tidy = arranged(untidy.input);
      CHECK(!breach(tidy));
      for (const Point& point : tidy.points)
        CHECK(std::all_of(point.begin(), point.end(), is_double));
      if (const auto found = breach(untidy.input)) met.insert(*found);
    }
    CAPTURE(name(kind));
    for (const BreachKind one : breaches) CHECK(met.count(one) == 1);
  }
}

TEST_CASE("a domain without segments stays as it is") {
  ComplexCase whole;
  whole.input.points = {{0, 0}, {1, 0}};
  Dice dice(1);
  CHECK(untidied(dice, whole, {Untidiness::kCrossing}).input.points.size() == 2);
}

}  // namespace

// ---- Dice ----
// The guarantees of a seed: the same numbers on every machine, all equally likely.

namespace {

TEST_CASE("dice: splitmix64, by the numbers that its authors' program prints") {
  Dice dice(1234567);
  for (const std::uint64_t bits : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                   4593380528125082431U, 16408922859458223821U}) {
    CHECK(dice.bits() == bits);
  }
}

TEST_CASE("dice: all numbers of a range, all equally often, whatever its length") {
  Dice dice(7);
  std::array<int, 11> often{};
  for (int i = 0; i < 11'000; ++i) ++often[static_cast<std::size_t>(dice.within(-5, 5) + 5)];
  for (const int times : often) CHECK(std::abs(times - 1000) < 150);
  // For a count of three quarters of 2^64, remainders would make the lowest third twice as likely.
  const std::size_t count = std::size_t{3} << 62;
  int low = 0;
  for (int i = 0; i < 9'000; ++i) low += dice.below(count) < (std::size_t{1} << 62) ? 1 : 0;
  CHECK(std::abs(low - 3000) < 200);
  CHECK(dice.below(1) == 0);
  CHECK(dice.within(3L, 3L) == 3);
}

}  // namespace

}  // namespace circumspect::generators
