// Bistellar flips, insertion by flips, and the flip algorithm. Book: Section 4.4; Section 2.5 in
// the plane.
#include <algorithm>

#include <doctest/doctest.h>

#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

// ---- Bistellar flips, each of Figure 4.6, and those that are blocked ----

using Simplices = std::vector<Simplex>;

// The name of the flip that removes a facet, and the resulting triangulation. In space, the
// procedure of Figure 4.8 must agree. Flipping back must restore the triangulation.
std::string flipped(const PointSet& points, const Simplices& start, const Simplex& facet,
                    const Simplices& expected) {
  StarIndex triangulation(start);
  const BasicFlip basic = flip_of_facet(points, triangulation, facet);
  const auto extended = extended_flip(triangulation, basic);
  REQUIRE(extended.has_value());
  triangulation.replace(extended->deleted, extended->created);
  CHECK(triangulation.triangulation(points.dimension()) ==
        Triangulation(points.dimension(), expected));
  if (points.dimension() == 3) {
    StarIndex of_the_book(start);
    const auto performed = flip(points, of_the_book, facet[0], facet[1], facet[2]);
    REQUIRE(performed.has_value());
    CHECK(performed->name() == extended->name());
    CHECK(of_the_book.simplices() == triangulation.simplices());
  }
  const auto back = extended_flip(triangulation, basic.reverse());
  REQUIRE(back.has_value());
  CHECK(back->created == extended->deleted);
  CHECK(back->deleted == extended->created);
  return extended->name();
}

// The name of the flip that splits a face with a new vertex, and the resulting triangulation.
std::string split(const PointSet& points, const Simplices& start, const Simplex& simplex, Vertex v,
                  const Simplices& expected) {
  StarIndex triangulation(start);
  const auto extended = extended_flip(triangulation, basic_flip(points, simplex, v));
  REQUIRE(extended.has_value());
  triangulation.replace(extended->deleted, extended->created);
  CHECK(triangulation.triangulation(points.dimension()) ==
        Triangulation(points.dimension(), expected));
  return extended->name();
}

// The simplices that block the flip that removes a facet; those that block the book's procedure
// must be among them.
Simplices missing(const PointSet& points, const Simplices& start, const Simplex& facet) {
  StarIndex triangulation(start);
  const auto extended = extended_flip(triangulation, flip_of_facet(points, triangulation, facet));
  REQUIRE(!extended.has_value());
  if (points.dimension() == 3) {
    const auto performed = flip(points, triangulation, facet[0], facet[1], facet[2]);
    REQUIRE(!performed.has_value());
    CHECK(!performed.error().missing.empty());
    const Simplices& all = extended.error().missing;
    for (const Simplex& simplex : performed.error().missing) {
      CHECK(std::find(all.begin(), all.end(), simplex) != all.end());
    }
    CHECK(triangulation.simplices() == StarIndex(start).simplices());
  }
  return extended.error().missing;
}

TEST_CASE("flips on a line: an edge is split and merged") {
  const PointSet line({{0}, {5}, {3}});
  CHECK(split(line, {{0, 1}}, {0, 1}, 2, {{0, 2}, {1, 2}}) == "1-2");
  CHECK(flipped(line, {{0, 2}, {1, 2}}, {2}, {{0, 1}}) == "2-1");
}

TEST_CASE("flips in the plane: 2-2, 1-3 and 3-1") {
  const PointSet square({{0, 0}, {3, 0}, {4, 4}, {0, 3}});
  CHECK(flipped(square, {{0, 1, 2}, {0, 2, 3}}, {0, 2}, {{0, 1, 3}, {1, 2, 3}}) == "2-2");
  const PointSet inside({{0, 0}, {6, 0}, {0, 6}, {1, 2}});
  const Simplices three{{0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  CHECK(split(inside, {{0, 1, 2}}, {0, 1, 2}, 3, three) == "1-3");
  for (const Simplex& edge : Simplices{{0, 3}, {1, 3}, {2, 3}}) {
    CHECK(flipped(inside, three, edge, {{0, 1, 2}}) == "3-1");
  }
}

TEST_CASE("flips in the plane: an edge is split and merged, inside and on the hull") {
  const PointSet points({{0, 0}, {4, 0}, {2, 3}, {2, -3}, {1, 0}});
  const Simplices above{{0, 2, 4}, {1, 2, 4}};
  const Simplices both{{0, 2, 4}, {1, 2, 4}, {0, 3, 4}, {1, 3, 4}};
  CHECK(split(points, {{0, 1, 2}}, {0, 1, 2}, 4, above) == "1-2");
  CHECK(split(points, {{0, 1, 2}, {0, 1, 3}}, {0, 1, 3}, 4, both) == "2-4");
  CHECK(flipped(points, above, {2, 4}, {{0, 1, 2}}) == "2-1");
  CHECK(flipped(points, both, {2, 4}, {{0, 1, 2}, {0, 1, 3}}) == "4-2");
}

TEST_CASE("basic flips in space: 2-3, 3-2, 1-4 and 4-1") {
  const PointSet bipyramid({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {1, 1, -3}});
  const Simplices two{{0, 1, 2, 3}, {0, 1, 2, 4}};
  const Simplices three{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  CHECK(flipped(bipyramid, two, {0, 1, 2}, three) == "2-3");
  for (const Simplex& facet : Simplices{{0, 3, 4}, {1, 3, 4}, {2, 3, 4}}) {
    CHECK(flipped(bipyramid, three, facet, two) == "3-2");
  }
  const PointSet inside({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {1, 2, 3}});
  const Simplices four{{0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  CHECK(split(inside, {{0, 1, 2, 3}}, {0, 1, 2, 3}, 4, four) == "1-4");
  for (const Simplex& facet : Simplices{{0, 1, 4}, {0, 2, 4}, {2, 3, 4}}) {
    CHECK(flipped(inside, four, facet, {{0, 1, 2, 3}}) == "4-1");
  }
}

TEST_CASE("extended flips in space: 2-2 on the hull, 4-4 inside") {
  const PointSet points({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 3, 0}, {1, 1, 2}, {1, 1, -5}});
  CHECK(flipped(points, {{0, 1, 2, 4}, {0, 2, 3, 4}}, {0, 2, 4}, {{0, 1, 3, 4}, {1, 2, 3, 4}}) ==
        "2-2");
  const Simplices four{{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 5}, {0, 2, 3, 5}};
  const Simplices other{{0, 1, 3, 4}, {1, 2, 3, 4}, {0, 1, 3, 5}, {1, 2, 3, 5}};
  CHECK(flipped(points, four, {0, 2, 4}, other) == "4-4");
  CHECK(flipped(points, four, {0, 2, 5}, other) == "4-4");
}

TEST_CASE("extended flips in space: a facet is split and merged, 1-3 and 3-1, 2-6 and 6-2") {
  const PointSet points({{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {1, 1, 4}, {2, 1, -4}, {1, 2, 0}});
  const Simplices three{{0, 1, 3, 5}, {0, 2, 3, 5}, {1, 2, 3, 5}};
  Simplices six{{0, 1, 4, 5}, {0, 2, 4, 5}, {1, 2, 4, 5}};
  six.insert(six.end(), three.begin(), three.end());
  const Simplices two{{0, 1, 2, 3}, {0, 1, 2, 4}};
  CHECK(split(points, {{0, 1, 2, 3}}, {0, 1, 2, 3}, 5, three) == "1-3");
  CHECK(split(points, two, {0, 1, 2, 4}, 5, six) == "2-6");
  CHECK(flipped(points, three, {1, 3, 5}, {{0, 1, 2, 3}}) == "3-1");
  CHECK(flipped(points, six, {1, 3, 5}, two) == "6-2");
}

TEST_CASE("extended flips in space: an edge is split and merged, inside and on the hull") {
  const PointSet points(
      {{0, 0, -2}, {0, 0, 2}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {-1, -1, 0}, {0, 0, 1}});
  const Simplices on_hull{{0, 1, 2, 3}, {0, 1, 3, 4}};
  const Simplices on_hull_split{{0, 2, 3, 6}, {1, 2, 3, 6}, {0, 3, 4, 6}, {1, 3, 4, 6}};
  CHECK(split(points, on_hull, {0, 1, 3, 4}, 6, on_hull_split) == "2-4");
  for (const Simplex& facet : Simplices{{2, 3, 6}, {3, 4, 6}}) {
    CHECK(flipped(points, on_hull_split, facet, on_hull) == "4-2");
  }
  Simplices inside = on_hull;
  inside.insert(inside.end(), {{0, 1, 4, 5}, {0, 1, 2, 5}});
  Simplices inside_split = on_hull_split;
  inside_split.insert(inside_split.end(), {{0, 4, 5, 6}, {1, 4, 5, 6}, {0, 2, 5, 6}, {1, 2, 5, 6}});
  CHECK(split(points, inside, {0, 1, 2, 5}, 6, inside_split) == "4-8");
  CHECK(flipped(points, inside_split, {4, 5, 6}, inside) == "8-4");
}

TEST_CASE("a 3-2 flip is blocked by a fourth tetrahedron at the edge (Figure 4.9, left)") {
  const PointSet points({{0, 0, -4}, {0, 0, 4}, {3, 0, 0}, {1, 3, 0}, {-3, 1, 0}, {-1, -3, 0}});
  const Simplices ring{{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 5}, {0, 1, 2, 5}};
  CHECK(missing(points, ring, {0, 1, 5}) == Simplices{{0, 1, 2, 4}});
  // On the other side of the edge a 2-3 flip is possible.
  CHECK(flipped(points, ring, {0, 1, 3},
                {{0, 1, 2, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}, {0, 1, 4, 5}, {0, 1, 2, 5}}) == "2-3");
}

TEST_CASE("a 4-1 flip is blocked where the vertex has more tetrahedra (Figure 4.9, right)") {
  // The vertex 4 in the tetrahedron 0123, where 5 has since been put into the tetrahedron 0124.
  const PointSet points({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {1, 2, 3}, {2, 2, 1}});
  const Simplices seven{{0, 1, 2, 5}, {0, 1, 4, 5}, {0, 2, 4, 5}, {1, 2, 4, 5},
                        {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  CHECK(missing(points, seven, {0, 3, 4}) == Simplices{{0, 1, 2, 4}});
}

TEST_CASE("a 4-4 flip is blocked where the two triangles have different links") {
  const PointSet points(
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 2}, {2, 0, -2}, {0, 2, -2}});
  const Simplices five{{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 5}, {0, 2, 3, 6}, {0, 2, 5, 6}};
  CHECK(missing(points, five, {0, 2, 4}) == Simplices{{0, 1, 2, 6}, {0, 2, 3, 5}});
}

TEST_CASE("a 3-1 flip is blocked in the plane at a vertex of degree four") {
  const PointSet points({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}});
  const Simplices four{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 4}};
  CHECK(missing(points, four, {1, 4}) == Simplices{{0, 2, 4}});
}

// ---- Insertion of vertices by flips: where the vertex may lie, and what a stuck insertion says
// ----

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

// ---- The flip algorithm: where it ends, where it is stuck, and how long it can take ----

TEST_CASE("flip algorithm: one edge flip in the plane, none where it is Delaunay already") {
  const PointSet points({{0, 0}, {3, 0}, {4, 4}, {0, 3}});
  const Triangulation wrong(2, {{0, 1, 2}, {0, 2, 3}});
  const FlippedTriangulation result = flip_algorithm(points, wrong);
  CHECK(result.triangulation == by_definition(points));
  CHECK(result.run.flips == 1);
  CHECK(!result.run.is_stuck());
  CHECK(flip_algorithm(points, result.triangulation).run.flips == 0);
}

TEST_CASE("flip algorithm: no point, one point, an edge") {
  CHECK(flip_algorithm(PointSet({}), Triangulation(-1, {})).triangulation == Triangulation(-1, {}));
  CHECK(flip_algorithm(PointSet({{1, 2}}), Triangulation(0, {{0}})).triangulation ==
        Triangulation(0, {{0}}));
  CHECK(flip_algorithm(PointSet({{1, 2}, {3, 4}}), Triangulation(1, {{0, 1}})).triangulation ==
        Triangulation(1, {{0, 1}}));
}

TEST_CASE("flip algorithm: perturbed tests choose between the diagonals of a square") {
  const PointSet square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Triangulation pulled(2, {{0, 1, 2}, {0, 2, 3}});
  const Triangulation other(2, {{0, 1, 3}, {1, 2, 3}});
  CHECK(flip_algorithm(square, other).triangulation == pulled);
  // To unperturbed tests both are Delaunay.
  CHECK(flip_algorithm(square, other, FlipTest::kUnperturbed).triangulation == other);
  CHECK(flip_algorithm(square, pulled, FlipTest::kUnperturbed).triangulation == pulled);
}

TEST_CASE("flip algorithm: a vertex too light is flipped out, on a line, in the plane, in space") {
  const PointSet line({{0}, {4}, {1}}, {0, 0, -9});
  CHECK(flip_algorithm(line, Triangulation(1, {{0, 2}, {1, 2}})).triangulation ==
        Triangulation(1, {{0, 1}}));
  const PointSet plane({{0, 0}, {6, 0}, {0, 6}, {1, 2}}, {0, 0, 0, -99});
  CHECK(flip_algorithm(plane, Triangulation(2, {{0, 1, 3}, {0, 2, 3}, {1, 2, 3}})).triangulation ==
        Triangulation(2, {{0, 1, 2}}));
  const PointSet space({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {1, 2, 3}}, {0, 0, 0, 0, -99});
  const Triangulation four(3, {{0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  CHECK(flip_algorithm(space, four).triangulation == Triangulation(3, {{0, 1, 2, 3}}));
}

TEST_CASE("flip algorithm: stuck in the plane with weights, every 3-1 flip blocked") {
  // Two nested triangles, 023 and a smaller one, 145, twisted inside it. Its vertices are so light
  // that all should go, but each has four edges or five, and no flip would reduce their number.
  const PointSet points({{0, 5}, {1, 3}, {0, 0}, {5, 1}, {2, 2}, {1, 2}}, {0, -12, 0, 0, -13, -12});
  const Triangulation start(
      2, {{0, 1, 2}, {0, 1, 4}, {0, 3, 4}, {1, 2, 5}, {1, 4, 5}, {2, 3, 5}, {3, 4, 5}});
  CHECK(by_definition(points) == Triangulation(2, {{0, 2, 3}}));
  for (const FlipTest test : {FlipTest::kPerturbed, FlipTest::kUnperturbed}) {
    const FlippedTriangulation result = flip_algorithm(points, start, test);
    CHECK(result.triangulation == start);
    CHECK(result.run.flips == 0);
    REQUIRE(result.run.blocked.size() == 6);
    CHECK(result.run.blocked[0].facet == Simplex{0, 1});
    CHECK(result.run.blocked[0].missing == std::vector<Simplex>{{1, 2, 4}});
    CHECK(result.run.blocked[5].facet == Simplex{4, 5});
    CHECK(result.run.blocked[5].missing == std::vector<Simplex>{{1, 3, 4}});
  }
}

TEST_CASE(
    "flip algorithm: facets found blocked before a flip elsewhere are still blocked after it") {
  // The same beside a quadrilateral, 0421, whose edge 14 is looked at last.
  const PointSet points({{-4, 1}, {-4, 5}, {0, 5}, {1, 3}, {0, 0}, {5, 1}, {2, 2}, {1, 2}},
                        {0, 0, 0, -12, 0, 0, -13, -12});
  const Triangulation start(2, {{2, 3, 4},
                                {2, 3, 6},
                                {2, 5, 6},
                                {3, 4, 7},
                                {3, 6, 7},
                                {4, 5, 7},
                                {5, 6, 7},
                                {0, 1, 4},
                                {1, 2, 4}});
  const FlippedTriangulation result = flip_algorithm(points, start);
  CHECK(result.run.flips == 1);
  CHECK(result.triangulation.has({0, 2, 4}));
  REQUIRE(result.run.blocked.size() == 6);
  CHECK(result.run.blocked[0].facet == Simplex{2, 3});
}

TEST_CASE("flip algorithm: the bound of Section 4.4") {
  CHECK(most_flips(0, 3) == 0);
  CHECK(most_flips(10, 1) == 2 * 10);
  CHECK(most_flips(10, 2) == 2 * (10 + 45));
  CHECK(most_flips(10, 3) == 2 * (10 + 45));
  CHECK(most_flips(10, 4) == 2 * (10 + 45 + 120));
  CHECK(most_flips(2, 4) == 2 * (2 + 1));
}

}  // namespace

}  // namespace circumspect::delaunay
