// Cells of a domain that are hardly farther from each other than the distance:
// docs/theory/within.md.
#include <doctest/doctest.h>

#include "oracle/judge/within/answers_test.hpp"

namespace circumspect::check {

TEST_CASE("within: a vertex near a segment that is not on it is free, whatever the distance") {
  const Domain square = square_with_steiner_points().domain;
  // A fan about a vertex 20 bits above the lower side.
  const Point low = {2, bits(20)};
  std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, low};
  ExactMesh fan{PointSet(points), {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  const MovedMesh exact{fan, square};
  CHECK(both_answers(exact, bits(10)) == "holds 0");
  CHECK(both_answers(exact, bits(30)) == "holds 0");
  const MovedMesh moved{moved_vertex(fan, {4, 4}, {bits(1), 0}), square};
  CHECK(both_answers(moved, bits(10)) == "holds 1");
  CHECK(both_answers(moved, bits(30)) == "holds 1");
}

TEST_CASE("within: cells that the distance does not tell apart are no matter of guessing") {
  // A short segment, one of whose ends has moved.
  const auto moved_by = [](long length, long distance) {
    PiecewiseLinearInput input = cuboid({0, 0}, {4, 4});
    input.points.push_back({2 + bits(length), 0});
    input.points.push_back({2, 0});
    input.segments = {{0, 5}, {5, 4}, {4, 1}, {1, 2}, {2, 3}, {0, 3}};
    std::vector<Point> points = input.points;
    points[4] = {2 + bits(length), bits(distance)};
    const std::vector<Simplex> fan = {{3, 0, 5}, {3, 5, 4}, {3, 4, 2}, {4, 1, 2}};
    return MovedMesh{{PointSet(points), fan}, domain_of(input)};
  };
  CHECK(both_answers(moved_by(5, 2)) == "not judged");
  CHECK(both_answers(moved_by(6, 2)) == "not judged");  // three times as long, exactly
  CHECK(both_answers(moved_by(7, 2)) == "holds 2");
  CHECK(both_answers(moved_by(5, 1)) == "holds 1");
}

TEST_CASE("within: of several cells that are near each other the nearest count") {
  // A short segment, one of whose ends has moved by 2 bits, and a lone vertex near another segment.
  const auto answer = [](long length, long height) {
    PiecewiseLinearInput input = cuboid({0, 0}, {4, 4});
    input.points.insert(input.points.end(), {{2 + bits(length), 0}, {2, 0}, {1, bits(height)}});
    input.segments = {{0, 5}, {5, 4}, {4, 1}, {1, 2}, {2, 3}, {0, 3}};
    std::vector<Point> points = input.points;
    points[4] = {2 + bits(length), bits(2)};
    const std::vector<Simplex> mesh = {{0, 5, 6}, {0, 6, 3}, {6, 5, 3},
                                       {3, 5, 4}, {3, 4, 2}, {4, 1, 2}};
    return both_answers({{PointSet(points), mesh}, domain_of(input)});
  };
  CHECK(answer(7, 7) == "holds 2");
  CHECK(answer(5, 7) == "not judged");
  CHECK(answer(7, 5) == "not judged");
}

TEST_CASE("within: a vertex across a wall that is nearer than three distances") {
  // A lone vertex 2 bits inside; in the mesh it is outside.
  PiecewiseLinearInput input = cuboid({0, 0}, {4, 4});
  input.points.push_back({2, bits(2)});
  const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, -bits(1)}};
  const std::vector<Simplex> mesh = {{0, 4, 3}, {4, 2, 3}, {4, 1, 2}};
  CHECK(both_answers({{PointSet(points), mesh}, domain_of(input)}) == "not judged");
}

TEST_CASE("within: a slot that a mesh bridges") {
  // A square with a slot of `width` from above, and a mesh that knows nothing of it.
  const auto bridged = [](const Rational& width) {
    PiecewiseLinearInput input;
    input.points = {{0, 0}, {4, 0}, {4, 4}, {2 + width, 4}, {2, 1}, {2, 4}, {0, 4}};
    for (Vertex v = 0; v < 7; ++v) input.segments.push_back({v, (v + 1) % 7});
    const ExactMesh mesh{PointSet(input.points),
                         {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 5, 4}, {5, 6, 4}, {6, 0, 4}}};
    return MovedMesh{mesh, domain_of(input)};
  };
  CHECK(both_answers(bridged(1)) == "fails domain.outside");
  MovedMesh narrow = bridged(bits(9));
  CHECK(both_answers(narrow) == "fails domain.outside");
  narrow.mesh = moved_vertex(narrow.mesh, {4, 4}, {bits(2), 0});
  CHECK(both_answers(narrow) == "fails domain.outside");
  narrow.mesh = moved_vertex(narrow.mesh, {4 + bits(2), 4}, {bits(2), 0});
  CHECK(both_answers(narrow) ==
        "not judged");  // the ends of the slot are less than 3 times 4 bits apart
}

TEST_CASE("within: a thin polygon that is mirrored") {
  const auto thin = [](const Rational& y) {
    return soup({{0, 0, 0}, {4, 0, 0}, {2, bits(4), 0}}, {{0, 1, 2}},
                {{0, 0, 0}, {4, 0, 0}, {2, y, 0}}, {{0, 1, 2}});
  };
  CHECK(both_answers(thin(bits(4))) == "holds 0");
  CHECK(both_answers(thin(bits(3))) == "holds 1");
  CHECK(both_answers(thin(-bits(4))) == "not judged");
  // Two layers of triangles on one polygon are one too many.
  MovedMesh twice = soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}},
                         {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, bits(2)}, {1, 1, -bits(2)}},
                         {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}});
  CHECK(both_answers(twice) == "fails domain.polygon-not-tiled");
}

}  // namespace circumspect::check
