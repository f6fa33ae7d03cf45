// Segments: which are strongly Delaunay, Delaunay, or neither; the shells around their ends; and
// how many points recover them.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/complex/circumball.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/split_segments.hpp"
#include "reference/constrained/steiner_cdt.hpp"

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

// The canonical triangulation gives the same answer as the linear program over all points.
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

TEST_CASE("protecting shells: which ends are acute") {
  const auto complex = segments_only({{0, 0}, {4, 0}, {4, 1}, {0, 3}, {-4, 0}},
                                     {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}});
  const ProtectingShells shells(complex);
  // Segments 0 1 and 0 2 make a narrow angle, so 0 2 and 0 3 count too; a right angle is not
  // narrow. The angle of 1 2 with 0 2 has a cosine below 1/4, and there is no narrower one at their
  // vertex.
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
    // Long enough for a subsegment that must be split at the least shell.
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

// Recovers the segments and checks all guarantees; returns how many points were added.
std::size_t steiner_points_of_recovery(const PiecewiseLinearComplex& complex) {
  const RecoveredSegments recovered = recover_segments(complex);
  CHECK(is_edge_protected(recovered.complex));
  CHECK(is_edge_protected_under_perturbation(recovered.complex));
  CHECK(recovered.complex.points.size() == complex.points.size() + recovered.steiner_points.size());
  CHECK(recovered.complex.segments.size() ==
        complex.segments.size() + recovered.steiner_points.size());
  auto next = static_cast<Vertex>(complex.points.size());
  for (const PointOnSegment& point : recovered.steiner_points) {
    CHECK(point.vertex == next++);
    const Simplex& segment = complex.segments[point.segment];
    const Point& start = complex.points[segment[0]];
    const Point along = complex.points[segment[1]] - start;
    CHECK(recovered.complex.points[point.vertex] == start + point.parameter * along);
  }
  return recovered.steiner_points.size();
}

// Segments from the origin to points on the circle about it, rational ones; each `turn` is the
// tangent of half the angle. Every second segment is `ratio` times as long.
PiecewiseLinearComplex fan(const std::vector<Rational>& turns, const Rational& ratio,
                           std::size_t dimension) {
  std::vector<Point> points = {Point(dimension, Rational(0))};
  std::vector<std::vector<Vertex>> segments;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Rational& t = turns[i];
    Point end(dimension, Rational(0));
    end[0] = (1 - t * t) / (1 + t * t);
    end[1] = 2 * t / (1 + t * t);
    if (dimension == 3) end[2] = t * t;
    if (i % 2 == 1) end = ratio * end;
    points.push_back(std::move(end));
    segments.push_back({0, static_cast<Vertex>(i + 1)});
  }
  return segments_only(std::move(points), std::move(segments));
}

TEST_CASE("segment recovery: what is edge-protected stays as it is") {
  const auto box = assemble(generators::box(0, 1));
  const RecoveredSegments recovered = recover_segments(box);
  CHECK(recovered.steiner_points.empty());
  CHECK(recovered.complex.segments == box.segments);
}

TEST_CASE("segment recovery: the complexes of Figures 4.10, 4.12, 4.13 and 4.15") {
  CHECK(steiner_points_of_recovery(assemble(generators::encircled_segment())) == 1);
  CHECK(steiner_points_of_recovery(assemble(generators::schonhardt())) == 3);
  CHECK(steiner_points_of_recovery(assemble(generators::cube_with_three_segments())) == 3);
  CHECK(steiner_points_of_recovery(assemble(generators::chazelle(1))) == 0);
  CHECK(steiner_points_of_recovery(assemble(generators::chazelle(2))) == 34);
}

TEST_CASE(
    "segment recovery: fans with angles of about one degree, with equal and with unequal arms") {
  std::vector<Rational> turns;
  for (int i = 0; i < 20; ++i) turns.push_back(Rational(i) / 115);
  CHECK(steiner_points_of_recovery(fan(turns, 1, 2)) == 0);
  CHECK(steiner_points_of_recovery(fan(turns, 2, 2)) == 9);
  CHECK(steiner_points_of_recovery(fan(turns, 1000, 2)) == 90);
  CHECK(steiner_points_of_recovery(fan(turns, Rational(22, 7), 3)) == 0);
}

TEST_CASE("segment recovery: fans in space that points encroach upon") {
  std::vector<Point> points = {{0, 0, 0}};
  std::vector<std::vector<Vertex>> segments;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const Rational length = 1 + (3 * i + 5 * j) % 7;
      points.push_back(length * Point{1, Rational(i) / 50, Rational(j) / 50});
      segments.push_back({0, static_cast<Vertex>(points.size() - 1)});
      points.push_back({Rational(1, 2 + i), Rational(2 * i + 1) / 400, Rational(2 * j + 1) / 400});
    }
  }
  const auto count =
      steiner_points_of_recovery(segments_only(std::move(points), std::move(segments)));
  CHECK(count >= 25);
  CHECK(count < 500);
}

TEST_CASE("segment recovery: needles, with points that encroach upon them") {
  for (const Rational& angle : {Rational(1, 10), Rational(1, 1000), Rational(1, 1000000)}) {
    const auto count = steiner_points_of_recovery(segments_only(
        {{0, 0}, {1, 0}, {3, 3 * angle}, {Rational(1, 2), angle / 4}, {Rational(1, 3), -angle / 3}},
        {{0, 1}, {0, 2}}));
    CHECK(count >= 2);
    CHECK(count < 300);
  }
}

// Where every vertex that is added is in the way of the other segment, these took hundreds.
TEST_CASE(
    "segment recovery: segments that run closely along each other get their vertices side by "
    "side") {
  const Rational thin(1, 1000);
  const std::vector<Point> around = {{50, 50, 0}, {50, -50, 0}, {50, 0, 50}};
  const auto count = [&](std::vector<Point> points, std::vector<std::vector<Vertex>> segments) {
    points.insert(points.end(), around.begin(), around.end());
    return steiner_points_of_recovery(segments_only(std::move(points), std::move(segments)));
  };
  CHECK(count({{0, 0, 0}, {100, 0, 0}, {100, thin, 0}}, {{0, 1}, {0, 2}, {1, 2}}) < 10);
  CHECK(count({{0, 0, 0}, {100, 0, 0}, {51, thin, 0}}, {{0, 1}, {0, 2}, {1, 2}}) < 10);
  CHECK(count({{0, 0, 0}, {100, 0, 0}, {93, thin, 0}}, {{0, 1}, {0, 2}, {1, 2}}) < 40);
  CHECK(count({{0, 0, 0}, {100, 0, 0}, {7, thin, 0}, {93, 2 * thin, 0}}, {{0, 1}, {2, 3}}) < 20);
}

TEST_CASE("segment recovery: three arms of very different lengths at tiny angles in space") {
  const Rational tiny(1, 1000);
  std::vector<Point> points = {{0, 0, 0}, {100000, 0, 0}, {1, tiny, 0}, {30, 0, tiny}};
  for (int x = 1; x < 6; ++x) {
    for (const Rational& y : std::vector<Rational>{-tiny, tiny}) {
      for (const Rational& z : std::vector<Rational>{-tiny, tiny}) {
        points.push_back({Rational(x) / 7, y / 4, z / 4});
        points.push_back({Rational(x) / 2, y / 5, z / 7});
      }
    }
  }
  const auto count =
      steiner_points_of_recovery(segments_only(std::move(points), {{0, 1}, {0, 2}, {0, 3}}));
  CHECK(count >= 2);
  CHECK(count < 300);
}

// Beams in three directions, cell by cell as in Figure 4.12.
TEST_CASE("segment recovery: a grid of skew segments that pass each other closely") {
  std::vector<Point> points;
  std::vector<std::vector<Vertex>> segments;
  const auto add = [&](const Point& start, const Point& end) {
    const auto first = static_cast<Vertex>(points.size());
    points.insert(points.end(), {start, end});
    segments.push_back({first, first + 1});
  };
  const Rational third(1, 3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      add({-9, i + third, Rational(j)}, {9, i + third, Rational(j)});
      add({Rational(i), -9, j + third}, {Rational(i), 9, j + third});
      add({i + third, Rational(j), -9}, {i + third, Rational(j), 9});
    }
  }
  const auto count =
      steiner_points_of_recovery(segments_only(std::move(points), std::move(segments)));
  CHECK(count >= 27);
  CHECK(count < 1500);
}

TEST_CASE("segment recovery: polygons get the points that are added to their segments") {
  const auto complex = assemble(generators::schonhardt());
  const RecoveredSegments recovered = recover_segments(complex);
  REQUIRE(recovered.complex.polygons.size() == complex.polygons.size());
  std::size_t added = 0;
  for (std::size_t i = 0; i < complex.polygons.size(); ++i) {
    const Polygon& before = complex.polygons[i];
    const Polygon& after = recovered.complex.polygons[i];
    added += after.vertices.size() - before.vertices.size();
    CHECK(after.segments.size() == after.vertices.size());
    CHECK(after.triangles.size() == after.vertices.size() - 2);
  }
  // Three points, each on an edge of two triangles.
  CHECK(added == 6);
}

}  // namespace
}  // namespace circumspect::constrained
