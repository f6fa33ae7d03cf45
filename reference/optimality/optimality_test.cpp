// What Delaunay triangulations optimise, and all triangulations of a set.
#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/simplex_predicates.hpp"
#include "reference/optimality/all_triangulations.hpp"
#include "reference/optimality/criteria.hpp"
#include "reference/optimality/flip_graph.hpp"

namespace circumspect::optimality {
namespace {

PointSet grid(long columns, long rows) {
  std::vector<Point> points;
  for (long x = 0; x < columns; ++x) {
    for (long y = 0; y < rows; ++y) points.push_back({x, y});
  }
  return PointSet(points);
}

PointSet cube() {
  std::vector<Point> points;
  for (long corner = 0; corner < 8; ++corner) {
    points.push_back({corner & 1, (corner >> 1) & 1, (corner >> 2) & 1});
  }
  return PointSet(points);
}

PointSet moment_curve(std::size_t dimension, long count) {
  std::vector<Point> points;
  for (long t = 0; t < count; ++t) {
    Point p{Rational(t)};
    while (p.size() < dimension) p.push_back(p.back() * t);
    points.push_back(p);
  }
  return PointSet(points);
}

struct Counts {
  std::size_t all_points;
  std::size_t some_points;
};

// Both enumerations give these numbers, and the same triangulations.
void check_counts(const PointSet& points, const Counts& expected) {
  for (const VertexUse use : {VertexUse::kAllPoints, VertexUse::kSomePoints}) {
    const std::vector<Triangulation> all = all_triangulations(points, use);
    CHECK(all.size() ==
          (use == VertexUse::kAllPoints ? expected.all_points : expected.some_points));
    CHECK(flip_graph_from(points, delaunay::by_definition(points), use).triangulations == all);
  }
}

TEST_CASE("all triangulations: no point, one, two, and points on a line") {
  check_counts(PointSet(std::vector<Point>{}), {1, 1});
  check_counts(PointSet(std::vector<Point>{Point{3, 4}}), {1, 1});
  check_counts(PointSet(std::vector<Point>{Point{3, 4}, Point{5, 6}}), {1, 1});
  check_counts(PointSet({{1, 1}, {0, 0}, {3, 3}, {2, 2}}), {1, 4});
}

TEST_CASE("all triangulations: a convex polygon has as many as Catalan's number") {
  check_counts(moment_curve(2, 4), {2, 2});
  check_counts(moment_curve(2, 5), {5, 5});
  check_counts(moment_curve(2, 6), {14, 14});
  check_counts(moment_curve(2, 7), {42, 42});
}

TEST_CASE("all triangulations: a square with its centre, the grids") {
  check_counts(PointSet({{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}}), {1, 3});
  check_counts(grid(3, 2), {6, 14});
  check_counts(grid(3, 3), {64, 387});
}

TEST_CASE("all triangulations: a square in space, where everything happens in its plane") {
  check_counts(PointSet({{0, 0, 5}, {1, 0, 6}, {0, 1, 5}, {1, 1, 6}}), {2, 2});
}

TEST_CASE("all triangulations: the cube, the octahedron, the prism, cyclic polytopes") {
  check_counts(cube(), {74, 74});
  check_counts(PointSet({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}),
               {3, 3});
  check_counts(PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}),
               {6, 6});
  check_counts(moment_curve(3, 6), {6, 6});
  check_counts(moment_curve(3, 7), {25, 25});
  check_counts(moment_curve(4, 6), {2, 2});
  check_counts(moment_curve(4, 7), {7, 7});
}

TEST_CASE("all triangulations: points on two skew lines have one, with (a-1)(b-1) tetrahedra") {
  const PointSet points(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 3, 1}, {0, 4, 1}});
  const std::vector<Triangulation> all = all_triangulations(points);
  REQUIRE(all.size() == 1);
  CHECK(all.front().simplices().size() == 6);
  CHECK(delaunay::is_delaunay(points, all.front()));
}

TEST_CASE("all triangulations: two concentric triangles have two that are not regular") {
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {2, 1}, {1, 2}});
  std::size_t regular = 0;
  const std::vector<Triangulation> all = all_triangulations(points, VertexUse::kSomePoints);
  CHECK(all.size() == 18);
  for (const Triangulation& one : all) {
    const auto heights = heights_of_regular(points, one);
    if (!heights) continue;
    ++regular;
    std::vector<Rational> weights;
    for (Vertex v = 0; points.names(v); ++v) {
      weights.push_back(squared_length(points[v]) - (*heights)[static_cast<std::size_t>(v)]);
    }
    CHECK(delaunay::by_definition(PointSet(points.points(), weights)) == one);
  }
  CHECK(regular == 16);
}

TEST_CASE("flip graph: of a pentagon it is a pentagon") {
  const PointSet points = moment_curve(2, 5);
  const FlipGraph graph = flip_graph_on(points, all_triangulations(points));
  CHECK(graph.is_connected());
  for (const auto& neighbours : graph.neighbours) CHECK(neighbours.size() == 2);
  FlipGraph cut = graph;
  for (auto& neighbours : cut.neighbours) neighbours.clear();
  CHECK_FALSE(cut.is_connected());
}

TEST_CASE("flip graph: the flips that create or delete a vertex are left out for all points") {
  const PointSet points({{0, 0}, {3, 0}, {0, 3}, {1, 1}});
  const std::vector<Circuit> all_circuits = circuits(points);
  REQUIRE(all_circuits.size() == 1);
  const Triangulation whole(2, {{0, 1, 2}});
  CHECK(neighbours(whole, all_circuits, VertexUse::kAllPoints).empty());
  const auto next = neighbours(whole, all_circuits, VertexUse::kSomePoints);
  REQUIRE(next.size() == 1);
  CHECK(next.front() == delaunay::by_definition(points));
}

TEST_CASE("barycentric coordinates: inside, outside, off the affine hull, degenerate") {
  const PointSet points({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {4, 0, 0}});
  const auto inside = barycentric_coordinates(points, {0, 1, 2}, {Rational(1, 2), 1, 0});
  REQUIRE(inside.has_value());
  CHECK(*inside == std::vector<Rational>{Rational(1, 4), Rational(1, 4), Rational(1, 2)});
  CHECK(is_convex(*inside));
  CHECK_FALSE(is_convex(*barycentric_coordinates(points, {0, 1, 2}, {3, 0, 0})));
  CHECK_FALSE(barycentric_coordinates(points, {0, 1, 2}, {0, 0, 1}).has_value());
  CHECK_FALSE(barycentric_coordinates(points, {0, 1, 3}, {0, 0, 0}).has_value());
}

TEST_CASE("simplicial complex: of two triangles that share an edge") {
  const Triangulation two(2, {{0, 1, 2}, {1, 2, 3}});
  CHECK(simplicial_complex(two).size() == 4 + 5 + 2);
}

TEST_CASE("interpolation error: on an edge it is a parabola with its top over the middle") {
  const PointSet points(std::vector<Point>{Point{0}, Point{4}});
  const Triangulation edge(1, {{0, 1}});
  CHECK(*lifted_height(points, edge, {1}) == 4);
  CHECK(*interpolation_error(points, edge, {1}) == 3);
  CHECK(*interpolation_error(points, edge, {0}) == 0);
  CHECK_FALSE(interpolation_error(points, edge, {5}).has_value());
  const GreatestError greatest = greatest_interpolation_error(points, edge);
  CHECK(greatest.where == Point{2});
  CHECK(greatest.error == 4);
  CHECK(lifted_integral(points, edge) == 64);  // 2! · 4 · 8
}

TEST_CASE("min-containment ball: an acute triangle has its circumball, an obtuse its long edge's") {
  const PointSet points({{0, 0}, {4, 0}, {2, 3}, {2, 1}});
  const Ball acute = min_containment_ball(points, {0, 1, 2});
  CHECK(acute.centre == Point{2, Rational(5, 6)});
  CHECK(acute.squared_radius == Rational(169, 36));
  const Ball obtuse = min_containment_ball(points, {0, 1, 3});
  CHECK(obtuse.centre == Point{2, 0});
  CHECK(obtuse.squared_radius == 4);
  CHECK(min_containment_ball(points, {2}).squared_radius == 0);
  const Triangulation all(2, {{0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
  CHECK(largest_min_containment_ball(points, all).squared_radius == 4);
}

TEST_CASE("nearest point: in the interior, on an edge, at a vertex") {
  const PointSet points({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  CHECK(nearest_point(points, {0, 1, 2}, {Rational(1, 2), Rational(1, 2), 7}) ==
        Point{Rational(1, 2), Rational(1, 2), 0});
  CHECK(nearest_point(points, {0, 1, 2}, {2, 2, 1}) == Point{1, 1, 0});
  CHECK(nearest_point(points, {0, 1, 2}, {-1, -1, 0}) == Point{0, 0, 0});
}

}  // namespace

}  // namespace circumspect::optimality
