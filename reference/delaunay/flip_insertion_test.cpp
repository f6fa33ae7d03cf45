// Insertion of vertices by flips: where the vertex may lie, and what a stuck insertion says. Book:
// Section 4.4, last paragraph.
#include "reference/delaunay/flip_insertion.hpp"

#include <doctest/doctest.h>

#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/flip_algorithm.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

// Inserts the last point into the canonical triangulation of the others.
struct LastInserted {
  explicit LastInserted(const PointSet& points) : triangulation(before(points).simplices()) {
    insertion =
        insert_vertex_by_flips(points, triangulation, static_cast<Vertex>(points.size()) - 1);
    is_canonical = triangulation.triangulation(points.dimension()) == by_definition(points);
  }
  static Triangulation before(const PointSet& points) {
    std::vector<Point> others(points.points().begin(), points.points().end() - 1);
    std::vector<Rational> weights;
    for (Vertex v = 0; points.is_weighted() && v + 1 < static_cast<Vertex>(points.size()); ++v) {
      weights.push_back(points.weight(v));
    }
    return by_definition(PointSet(std::move(others), std::move(weights)));
  }

  StarIndex triangulation;
  VertexInsertion insertion;
  bool is_canonical = false;
};

const std::vector<Point> kOctahedron{{2, 0, 0},  {-2, 0, 0}, {0, 2, 0},
                                     {0, -2, 0}, {0, 0, 3},  {0, 0, -3}};

std::vector<Point> octahedron_and(const Point& point) {
  std::vector<Point> points = kOctahedron;
  points.push_back(point);
  return points;
}

TEST_CASE("flip insertion: in a tetrahedron, in a facet, on an edge, on the hull, outside") {
  const Rational half(1, 2);
  const struct {
    Point point;
    std::optional<std::size_t> dimension_of_face;
  } cases[] = {
      {{half, half, half}, 3},
      {{half, half, 0}, 2},
      {{1, 1, 0}, 1},
      {{half, 0, Rational(9, 4)}, 1},
      {{half, half, Rational(3, 2)}, 2},
      {{5, 5, 5}, {}},
      {{0, 0, 7}, {}},
      {{3, 3, -3}, {}},
      {{2, 2, 0}, {}},
  };
  for (const auto& row : cases) {
    const auto& point = row.point;
    const auto& dimension_of_face = row.dimension_of_face;
    const PointSet points(octahedron_and(point));
    const LastInserted last(points);
    CAPTURE(point[0].get_str());
    CHECK(last.is_canonical);
    CHECK(!last.insertion.is_submerged);
    CHECK(!last.insertion.run.is_stuck());
    CHECK(last.insertion.dimension_of_face == dimension_of_face);
    CHECK(Integer(last.insertion.run.flips) <= most_flips(points.size(), 3));
  }
}

TEST_CASE("flip insertion: a submerged point changes nothing, a heavy one drowns others") {
  const std::vector<Point> points{{0, 0}, {8, 0}, {0, 8}, {3, 3}, {2, 3}};
  const LastInserted light(PointSet(points, {0, 0, 0, 0, -50}));
  CHECK(light.is_canonical);
  CHECK(light.insertion.is_submerged);
  CHECK(light.insertion.run.flips == 0);
  const LastInserted heavy(PointSet(points, {0, 0, 0, 0, 20}));
  CHECK(heavy.is_canonical);
  CHECK(heavy.triangulation.star({3}).empty());
  // A vertex of the hull that the new point carries into a hull edge, and out.
  const LastInserted edge(PointSet({{0, 0}, {0, 4}, {2, 0}, {5, 0}}, {0, 0, -9, 0}));
  CHECK(edge.is_canonical);
  CHECK(edge.triangulation.simplices() == std::set<Simplex>{{0, 1, 3}});
}

TEST_CASE("flip insertion: no point, one point, and sets of lower dimension") {
  CHECK(flip_insertion(PointSet({})) == Triangulation(-1, {}));
  CHECK(flip_insertion(PointSet({{3, 4}})) == Triangulation(0, {{0}}));
  CHECK(flip_insertion(PointSet({{3, 3}, {0, 0}, {1, 1}, {-2, -2}})) ==
        Triangulation(1, {{0, 2}, {1, 2}, {1, 3}}));
  const PointSet square({{0, 0, 1}, {1, 0, 2}, {1, 1, 2}, {0, 1, 1}});
  CHECK(flip_insertion(square) == by_definition(square));
}

}  // namespace
}  // namespace circumspect::delaunay
