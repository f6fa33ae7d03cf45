// What every family must do: sets of the right size and dimension, the same for a seed, that
// shrink.
#include "inputs/families.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

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
}  // namespace circumspect::generators
