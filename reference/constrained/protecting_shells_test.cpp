// Shells: equal lengths as nearly as the angle demands.
#include "reference/constrained/protecting_shells.hpp"

#include <doctest/doctest.h>

namespace circumspect::constrained {
namespace {

PiecewiseLinearComplex segments_only(std::vector<Point> points,
                                     std::vector<std::vector<Vertex>> segments) {
  PiecewiseLinearInput input;
  input.points = std::move(points);
  input.segments = std::move(segments);
  input.kind = DomainKind::kHull;
  return assemble(input);
}

TEST_CASE("protecting shells: which ends are acute") {
  const auto complex = segments_only({{0, 0}, {4, 0}, {4, 1}, {0, 3}, {-4, 0}},
                                     {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}});
  const ProtectingShells shells(complex);
  // Segments 0 1 and 0 2 make a narrow angle, so 0 2 and 0 3 count too; a right one is none. That of
  // 1 2 with 0 2 has a cosine below 1/4, and there is no narrower one at their vertex.
  CHECK(shells.is_acute(0, 0));
  CHECK(shells.is_acute(1, 0));
  CHECK(shells.is_acute(2, 0));
  CHECK_FALSE(shells.is_acute(3, 0));
  CHECK_FALSE(shells.is_acute(0, 1));
  CHECK_FALSE(shells.is_acute(1, 2));
  CHECK_FALSE(shells.is_acute(4, 2));
}

TEST_CASE("protecting shells: points on one shell are not in each other's diametral balls") {
  const Rational tiny(1, 12345);
  const auto complex =
      segments_only({{0, 0, 0}, {7, 0, 0}, {5, tiny, 0}, {3, tiny, tiny}, {2, 3, 5}},
                    {{0, 1}, {0, 2}, {0, 3}, {0, 4}});
  const ProtectingShells shells(complex);
  const Rational least = shells.squared_least_shell(0);
  CHECK(shells.squared_width(0) > 1);
  std::vector<Point> ends;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point& tip = complex.points[static_cast<Vertex>(i + 1)];
    // Long enough for a subsegment that is to be split at the least shell.
    const Rational fraction = shells.where_to_split(i, 0, Rational(9, 4) * least);
    ends.push_back(fraction * tip);
    CHECK(squared_length(ends.back()) >= least);
    CHECK(squared_length(ends.back()) <= shells.squared_width(0) * least);
    // The denominator is a power of two.
    const Integer denominator = fraction.get_den();
    CHECK((denominator & (denominator - 1)) == 0);
  }
  for (const Point& a : ends) {
    for (const Point& b : ends) {
      if (a != b) CHECK(inner_product(a - b, b) < 0);
    }
  }
}

TEST_CASE("protecting shells: the least one keeps clear of everything else") {
  // A vertex at distance 40; then, nearer, the middle of a segment at distance 8. A quarter of
  // either.
  const auto vertex = segments_only({{0, 0}, {100, 0}, {100, 10}, {0, 40}}, {{0, 1}, {0, 2}});
  CHECK(ProtectingShells(vertex).squared_least_shell(0) == 64);
  const auto segment = segments_only({{0, 0}, {100, 0}, {100, 10}, {0, 40}, {-8, -70}, {-8, 70}},
                                     {{0, 1}, {0, 2}, {4, 5}});
  CHECK(ProtectingShells(segment).squared_least_shell(0) == 4);
}

}  // namespace
}  // namespace circumspect::constrained
