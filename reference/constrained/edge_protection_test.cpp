// Segments that are strongly Delaunay, Delaunay, and not, with balls and encroaching vertices.
#include "reference/constrained/edge_protection.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"

namespace circumspect::constrained {
namespace {

using delaunay::Delaunayhood;

PiecewiseLinearComplex segments_only(std::vector<Point> points,
                                     std::vector<std::vector<Vertex>> segments) {
  PiecewiseLinearInput input;
  input.points = std::move(points);
  input.segments = std::move(segments);
  input.kind = DomainKind::kHull;
  return assemble(input);
}

// What is found through the canonical triangulation is what the linear program over all points says.
void check_against_definition(const PiecewiseLinearComplex& complex) {
  bool all_strong = true;
  bool all_present = true;
  for (const SegmentProtection& protection : edge_protection(complex)) {
    const auto expected = delaunay::delaunayhood(complex.points, protection.segment);
    CHECK(protection.status.delaunayhood == expected.delaunayhood);
    CHECK(protection.status.ball.has_value() == expected.ball.has_value());
    CHECK(protection.status.obstruction.has_value() == expected.obstruction.has_value());
    all_strong = all_strong && expected.delaunayhood == Delaunayhood::kStronglyDelaunay;
    all_present = all_present && protection.is_present;
    if (protection.status.ball) {
      for (Vertex q = 0; complex.points.names(q); ++q) {
        const int where = sign(power(complex.points, *protection.status.ball, q));
        if (contains(protection.segment, q)) {
          CHECK(where == 0);
        } else {
          CHECK(where >= (protection.status.obstruction ? 0 : 1));
        }
      }
    }
    const auto encroaching = encroaching_vertex(complex.points, protection);
    CHECK(encroaching.has_value() == protection.status.obstruction.has_value());
    if (encroaching) {
      const Ball diametral = circumball(complex.points, protection.segment);
      CHECK(sign(power(complex.points, diametral, *encroaching)) <= 0);
      CHECK_FALSE(contains(protection.segment, *encroaching));
    }
  }
  CHECK(is_edge_protected(complex) == all_strong);
  CHECK(is_edge_protected_under_perturbation(complex) == all_present);
}

TEST_CASE(
    "edge protection: all segments of a box are strongly Delaunay, its long diagonals are not") {
  auto box = generators::box(0, 1);
  CHECK(is_edge_protected(assemble(box)));
  for (const Vertex corner : {0, 1, 2, 3}) {
    box = generators::box(0, 1);
    box.segments = {{corner, 7 - corner}};
    const auto complex = assemble(box);
    check_against_definition(complex);
    CHECK_FALSE(is_edge_protected(complex));
    // Only the diagonal from the first corner is in the canonical triangulation.
    CHECK(is_edge_protected_under_perturbation(complex) == (corner == 0));
  }
}

TEST_CASE("edge protection: a square's diagonals, in the plane and in a plane of space") {
  check_against_definition(segments_only({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 2}}));
  check_against_definition(segments_only({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{1, 3}, {0, 1}}));
  check_against_definition(
      segments_only({{0, 0, 0}, {2, 0, 2}, {2, 2, 4}, {0, 2, 2}, {1, 3, 4}}, {{1, 3}, {2, 4}}));
}

TEST_CASE("edge protection: points on a line") {
  check_against_definition(segments_only({{0, 0}, {1, 1}, {2, 2}}, {{0, 1}, {1, 2}}));
  check_against_definition(segments_only({{0, 0, 0}, {1, 1, 1}}, {{0, 1}}));
}

TEST_CASE("edge protection: a missing segment and what encroaches upon it") {
  const auto complex = segments_only({{-3, 0}, {0, -1}, {3, 0}, {0, 2}}, {{0, 2}});
  const SegmentProtection protection = edge_protection(complex).front();
  CHECK_FALSE(protection.is_present);
  CHECK(protection.status.delaunayhood == Delaunayhood::kNotDelaunay);
  CHECK(encroaching_vertex(complex.points, protection) == 1);
  check_against_definition(complex);
}

TEST_CASE("edge protection: an edge of the hull whose diametral ball is not empty") {
  check_against_definition(
      segments_only({{-2, 0, 0}, {2, 0, 0}, {0, 1, 1}, {0, 1, -1}, {0, 9, 0}}, {{0, 1}, {2, 3}}));
}

TEST_CASE("edge protection: the named complexes, by the definition") {
  check_against_definition(assemble(generators::schonhardt()));
  check_against_definition(assemble(generators::encircled_segment()));
  check_against_definition(assemble(generators::cube_with_three_segments()));
  check_against_definition(assemble(generators::chazelle(2)));
}

TEST_CASE("edge protection: points of a grid, where everything is Delaunay in many ways") {
  PiecewiseLinearInput input;
  for (int i = 0; i < 27; ++i) input.points.push_back({i % 3, i / 3 % 3, i / 9});
  // A space diagonal, a face diagonal and an edge of a cell, and one across two cells.
  input.segments = {{13, 26}, {0, 4}, {1, 2}, {4, 25}, {9, 18}, {2, 23}};
  input.kind = DomainKind::kHull;
  check_against_definition(assemble(input));
}

}  // namespace
}  // namespace circumspect::constrained
