// Segments that are recovered by splitting them, and how often.
#include "reference/constrained/segment_recovery.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "reference/constrained/edge_protection.hpp"

namespace circumspect::constrained {
namespace {

// Recovers the segments and asks for all that is promised; how many points were added.
std::size_t steiner_points_of(const PiecewiseLinearComplex& complex) {
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

PiecewiseLinearComplex segments_only(std::vector<Point> points,
                                     std::vector<std::vector<Vertex>> segments) {
  PiecewiseLinearInput input;
  input.points = std::move(points);
  input.segments = std::move(segments);
  input.kind = DomainKind::kHull;
  return assemble(input);
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
  CHECK(steiner_points_of(assemble(generators::encircled_segment())) == 1);
  CHECK(steiner_points_of(assemble(generators::schonhardt())) == 3);
  CHECK(steiner_points_of(assemble(generators::cube_with_three_segments())) == 3);
  CHECK(steiner_points_of(assemble(generators::chazelle(1))) == 0);
  CHECK(steiner_points_of(assemble(generators::chazelle(2))) == 34);
}

TEST_CASE(
    "segment recovery: fans with angles of about one degree, with equal and with unequal arms") {
  std::vector<Rational> turns;
  for (int i = 0; i < 20; ++i) turns.push_back(Rational(i) / 115);
  CHECK(steiner_points_of(fan(turns, 1, 2)) == 0);
  CHECK(steiner_points_of(fan(turns, 2, 2)) == 9);
  CHECK(steiner_points_of(fan(turns, 1000, 2)) == 90);
  CHECK(steiner_points_of(fan(turns, Rational(22, 7), 3)) == 0);
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
  const auto count = steiner_points_of(segments_only(std::move(points), std::move(segments)));
  CHECK(count >= 25);
  CHECK(count < 500);
}

TEST_CASE("segment recovery: needles, with points that encroach upon them") {
  for (const Rational& angle : {Rational(1, 10), Rational(1, 1000), Rational(1, 1000000)}) {
    const auto count = steiner_points_of(segments_only(
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
    return steiner_points_of(segments_only(std::move(points), std::move(segments)));
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
  const auto count = steiner_points_of(segments_only(std::move(points), {{0, 1}, {0, 2}, {0, 3}}));
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
  const auto count = steiner_points_of(segments_only(std::move(points), std::move(segments)));
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
