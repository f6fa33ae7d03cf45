// Families of complexes: what they promise.
#include "inputs/complex_families.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "inputs/cases.hpp"
#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/untidy.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::generators {
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
}  // namespace circumspect::generators
