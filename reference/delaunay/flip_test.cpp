// Bistellar flips, each of Figure 4.6, and those that are blocked. Book: Section 4.4.
#include "reference/delaunay/flip.hpp"

#include <algorithm>

#include <doctest/doctest.h>

namespace circumspect::delaunay {
namespace {

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

}  // namespace
}  // namespace circumspect::delaunay
