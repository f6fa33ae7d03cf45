#include "inputs/complex_families.hpp"

#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"

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
