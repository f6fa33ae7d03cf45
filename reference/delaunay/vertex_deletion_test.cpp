// Deleting vertices whose absence has a known effect. Book: Section 5.6.
#include "reference/delaunay/vertex_deletion.hpp"

#include <doctest/doctest.h>

#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

TEST_CASE("vertex deletion: an inner vertex, its star filled from its link") {
  const PointSet points({{0, 0}, {4, 0}, {5, 3}, {0, 4}, {2, 1}});
  const Triangulation whole = by_definition(points);
  CHECK(whole.simplices().size() == 4);
  const PointSet without({{0, 0}, {4, 0}, {5, 3}, {0, 4}});
  CHECK(delete_vertex(points, whole, 4) == by_definition(without));
}

TEST_CASE("vertex deletion: a hull vertex leaves room outside, and what it hid is hull") {
  const PointSet points({{0, 0}, {4, 0}, {2, 1}, {2, 5}});
  CHECK(delete_vertex(points, by_definition(points), 3) == Triangulation(2, {{0, 1, 2}}));
  // The link of the deleted vertex is not convex; the hull of the rest is.
  const PointSet dented({{0, 0}, {8, 0}, {2, 3}, {6, 3}, {4, 9}, {4, 4}});
  const PointSet rest({{0, 0}, {8, 0}, {2, 3}, {6, 3}, {4, 4}});
  std::vector<Simplex> expected = by_definition(rest).simplices();
  for (Simplex& simplex : expected) {
    for (Vertex& v : simplex) v = v == 4 ? 5 : v;
  }
  CHECK(delete_vertex(dented, by_definition(dented), 4) == Triangulation(2, expected));
}

TEST_CASE("vertex deletion: the apex of a pyramid drops a dimension, down to nothing") {
  const PointSet points({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 1, 5}});
  Triangulation rest = delete_vertex(points, by_definition(points), 4);
  CHECK(rest == Triangulation(2, {{0, 1, 3}, {0, 2, 3}}));
  rest = delete_vertex(points, rest, 0);
  CHECK(rest == Triangulation(2, {{1, 2, 3}}));
  rest = delete_vertex(points, rest, 2);
  CHECK(rest == Triangulation(1, {{1, 3}}));
  rest = delete_vertex(points, rest, 3);
  CHECK(rest == Triangulation(0, {{1}}));
  CHECK(delete_vertex(points, rest, 1) == Triangulation(-1, {}));
}

TEST_CASE("vertex deletion: submerged points surface, and keep the dimension up") {
  // The heavy point 2 submerges 1 and 3 on a line.
  const PointSet line({{0}, {1}, {2}, {3}, {4}}, {0, 0, 9, 0, 0});
  const Triangulation whole = by_definition(line);
  CHECK(whole == Triangulation(1, {{0, 2}, {2, 4}}));
  CHECK(delete_vertex(line, whole, 2, {1, 3}) == Triangulation(1, {{0, 1}, {1, 3}, {3, 4}}));
  CHECK(delete_vertex(line, whole, 2) == Triangulation(1, {{0, 4}}));
  // A hull vertex whose deletion would drop the dimension if it did not submerge a point.
  const PointSet triangle({{0, 0}, {4, 0}, {2, 3}, {2, 1}}, {0, 0, 100, 0});
  CHECK(by_definition(triangle) == Triangulation(2, {{0, 1, 2}}));
  CHECK(delete_vertex(triangle, Triangulation(2, {{0, 1, 2}}), 2, {3}) ==
        Triangulation(2, {{0, 1, 3}}));
}

}  // namespace
}  // namespace circumspect::delaunay
