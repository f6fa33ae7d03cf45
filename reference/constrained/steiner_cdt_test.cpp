// Steiner CDTs of complexes that have no triangulation. Book: Section 4.5.3.
#include "reference/constrained/steiner_cdt.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"

namespace circumspect::constrained {
namespace {

// All algorithms give the same answer; returns the number of its Steiner points.
std::size_t steiner_points_of_cdt(const PiecewiseLinearComplex& complex) {
  const SteinerCdt by_flips = steiner_cdt(complex);
  for (const CdtAlgorithm other : {CdtAlgorithm::kGiftWrapping, CdtAlgorithm::kPolygonCavities}) {
    const SteinerCdt answer = steiner_cdt(complex, other);
    CHECK(answer.triangulation == by_flips.triangulation);
    CHECK(answer.steiner_points == by_flips.steiner_points);
  }
  CHECK(by_flips.triangulation.dangling.empty());
  return by_flips.steiner_points.size();
}

TEST_CASE("steiner CDT: a box needs nothing") {
  const SteinerCdt answer = steiner_cdt(assemble(generators::box(0, 1)));
  CHECK(answer.steiner_points.empty());
  CHECK(answer.triangulation.simplices.size() == 6);
}

TEST_CASE("steiner CDT: the book's complexes without a triangulation, or without a CDT") {
  CHECK(steiner_points_of_cdt(assemble(generators::schonhardt())) == 3);
  CHECK(steiner_points_of_cdt(assemble(generators::cube_with_three_segments())) == 3);
  CHECK(steiner_points_of_cdt(assemble(generators::chazelle(2))) == 34);
  // "The PLC in Figure 4.15 has a Steiner CDT with one Steiner point on its central segment."
  const auto encircled = assemble(generators::encircled_segment());
  CHECK(steiner_points_of_cdt(encircled) == 1);
  const PointOnSegment point = steiner_cdt(encircled).steiner_points.front();
  CHECK(encircled.segments[point.segment] == Simplex{3, 4});
}

TEST_CASE("steiner CDT: in the plane there is no need for Steiner points") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {9, 0}, {9, 1}, {0, 1}, {4, Rational(1, 2)}, {8, Rational(1, 9)}};
  input.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}};
  const SteinerCdt answer = steiner_cdt(assemble(input));
  CHECK(answer.steiner_points.empty());
  CHECK(answer.triangulation.simplices.size() == 6);
}

}  // namespace
}  // namespace circumspect::constrained
