// The definition of the claim `complex`: what is set apart, the kinds of improper pairs, and what
// more can be asked.
#include "oracle/judge/definition/complex.hpp"

#include <doctest/doctest.h>

namespace circumspect::definition {
namespace {

using Places = std::vector<std::size_t>;

ImproperPairs improper(const std::vector<Point>& points, const std::vector<Simplex>& simplices) {
  const ListedComplex listed{points, simplices};
  return improper_pairs(listed, set_apart(listed, simplices.front().size()));
}
bool is_proper(const ImproperPairs& pairs) {
  return pairs.overlaps.empty() && pairs.hanging.empty() && pairs.crossing.empty();
}

// The first has the lesser coordinates on all axes: a grid of n × n squares, each cut in two.
std::vector<Point> grid(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n * n; ++i) points.push_back({i % n, i / n});
  return points;
}

TEST_CASE("what cannot be compared is set apart, and its vertices are used") {
  std::vector<Point> points = grid(3);
  points.push_back({1, 1});  // 9 is 4 again
  points.push_back({7, 7});
  points.push_back({8, 8});
  const SetApart apart = set_apart({points,
                                    {{0, 1, 4},
                                     {0, 1, 2},
                                     {4, 1, 1},
                                     {4, 9, 5},
                                     {9, 1, 0},
                                     {1, 2, 99},
                                     {-1, 2, 3},
                                     {1, 2},
                                     {},
                                     {8, 7, 10}}},
                                   3);
  CHECK(apart.equal_points.size() == 1);
  CHECK(apart.equal_points[0].kept == 4);
  CHECK(apart.equal_points[0].again == 9);
  CHECK(apart.flat == Places{1});
  CHECK(apart.repeating == Places{2, 3});  // one after merging
  CHECK(apart.doubled == Places{4});
  CHECK(apart.not_simplices == Places{5, 6, 7, 8});
  CHECK(apart.compared == Places{0, 9});
  CHECK(apart.unused_points == std::vector<Vertex>{6, 11});
  CHECK(apart.merged[4] == Simplex{4, 1, 0});
}

TEST_CASE("two triangles overlap, hang or touch") {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {0, 4}, {4, 4},
                                     {2, 2}, {2, 0}, {9, 9}, {2, -3}};
  CHECK(is_proper(improper(points, {{0, 1, 2}, {1, 2, 3}})));
  CHECK(improper(points, {{0, 1, 2}, {1, 3, 4}}).hanging ==
        std::vector<HangingVertex>{{4, {1, 2}}});
  CHECK(improper(points, {{0, 1, 2}, {1, 3, 2}, {0, 1, 3}}).overlaps ==
        std::vector<std::array<std::size_t, 2>>{{0, 2}, {1, 2}});
  // The vertex 5 in the edge 0 1, of two triangles that are beyond it: once.
  const ImproperPairs pairs = improper(points, {{0, 1, 2}, {0, 5, 7}, {5, 1, 7}});
  CHECK(pairs.overlaps.empty());
  CHECK(pairs.hanging == std::vector<HangingVertex>{{5, {0, 1}}});
  CHECK(pairs.crossing.empty());
  // Where triangles overlap nothing else is said of these two.
  CHECK(improper(points, {{0, 1, 2}, {0, 5, 3}}).hanging.empty());
}

// Two halves of an octahedron above and below a square, cut along different diagonals.
const std::vector<Point> kHalves = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                    {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const std::vector<Simplex> kCrossed = {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 3, 5}, {1, 2, 3, 5}};

TEST_CASE("two diagonals of a square cross, unless a flat simplex has them") {
  const ImproperPairs pairs = improper(kHalves, kCrossed);
  CHECK(pairs.overlaps.empty());
  CHECK(pairs.hanging.empty());
  CHECK(pairs.crossing == std::vector<CrossingFaces>{{{0, 2}, {1, 3}}});
  std::vector<Simplex> with_flat = kCrossed;
  with_flat.push_back({0, 1, 2, 3});
  CHECK(is_proper(improper(kHalves, with_flat)));
  CHECK(is_proper(improper(kHalves, {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 5}, {0, 2, 3, 5}})));
}

TEST_CASE("each is said once, and nothing that another fault explains") {
  // A flat triangle fills the gap at a vertex in an edge.
  const std::vector<Point> points = {{0, 0}, {4, 0}, {0, 4}, {2, 0}, {2, -3}, {2, -1}};
  const std::vector<Simplex> hanging = {{0, 1, 2}, {0, 3, 4}, {3, 1, 4}};
  std::vector<Simplex> filled = hanging;
  filled.push_back({0, 1, 3});
  CHECK(improper(points, hanging).hanging.size() == 1);
  CHECK(is_proper(improper(points, filled)));
  // So does a triangle at that vertex which overlaps one at that edge.
  std::vector<Simplex> overlapping = hanging;
  overlapping.push_back({3, 2, 5});
  CHECK(improper(points, overlapping).overlaps.size() == 2);
  CHECK(improper(points, overlapping).hanging.empty());
  // Two tetrahedra whose bases are a star of six points: edges cross, and nothing else is minimal.
  const std::vector<Point> star = {{0, 0, 0}, {6, 0, 0},  {3, 6, 0}, {0, 4, 0},
                                   {6, 4, 0}, {3, -2, 0}, {3, 2, 9}, {3, 2, -9},
                                   {3, 0, 0}, {4, 8, 0},  {2, 8, 0}};
  const ImproperPairs crossing = improper(star, {{0, 1, 2, 6}, {3, 4, 5, 7}});
  CHECK(crossing.crossing.size() == 6);
  CHECK(crossing.hanging.empty());
  // Two bases, each with a vertex in the other, whose edges cross: only the first is
  // said.
  const ImproperPairs both = improper(star, {{0, 1, 2, 6}, {8, 9, 10, 7}});
  CHECK(both.hanging == std::vector<HangingVertex>{{2, {8, 9, 10}}, {8, {0, 1}}});
  CHECK(both.crossing.empty());
}

TEST_CASE("triangles and edges in space") {
  // An edge through a triangle, and a vertex in the middle of one.
  const std::vector<Point> points = {{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {2, 2, -1}, {2, 2, 1},
                                     {9, 9, 9}, {2, 2, 0}, {5, 5, 5}, {1, 1, 0}};
  const ImproperPairs through = improper(points, {{0, 1, 2}, {3, 4, 5}});
  CHECK(through.overlaps.size() == 1);  // relative interiors meet
  const ImproperPairs at_edge = improper(points, {{0, 1, 2}, {8, 4, 5}, {8, 5, 7}});
  CHECK(at_edge.hanging == std::vector<HangingVertex>{{8, {0, 1, 2}}});
  CHECK(improper(points, {{0, 1}, {1, 2}, {2, 0}}).overlaps.empty());
  const std::vector<Point> cross = {{0, 0}, {2, 2}, {0, 2}, {2, 0}, {1, 1}};
  CHECK(improper(cross, {{0, 1}, {2, 3}}).overlaps.size() == 1);
  CHECK(improper(cross, {{0, 1}, {2, 4}}).hanging == std::vector<HangingVertex>{{4, {0, 1}}});
}

TEST_CASE("manifold, connected and closed") {
  const std::vector<Simplex> square = {{0, 1, 2}, {0, 2, 3}};
  CHECK(not_manifold(square).facets.empty());
  CHECK(not_manifold(square).ridges.empty());
  CHECK(not_manifold(square).vertices.empty());
  CHECK(parts(square) == 1);
  CHECK(open_facets(square) == std::vector<Simplex>{{0, 1}, {0, 3}, {1, 2}, {2, 3}});
  CHECK(open_facets({{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}).empty());
  CHECK(not_manifold({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}).facets == std::vector<Simplex>{{0, 1}});
  CHECK(not_manifold({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}).vertices.empty());
  // Two triangles that touch in a vertex, and two spheres that do.
  const std::vector<Simplex> bow = {{0, 1, 2}, {0, 3, 4}};
  CHECK(not_manifold(bow).ridges == std::vector<Simplex>{{0}});
  CHECK(not_manifold(bow).vertices.empty());
  CHECK(parts(bow) == 2);
  std::vector<Simplex> spheres;
  for (const Simplex& four : std::vector<Simplex>{{0, 1, 2, 3}, {0, 4, 5, 6}}) {
    for (std::size_t i = 0; i < 4; ++i) spheres.push_back(facet_opposite(four, i));
  }
  CHECK(not_manifold(spheres).ridges.empty());
  CHECK(not_manifold(spheres).vertices == std::vector<Vertex>{0});
  // Tetrahedra that share an edge, or a vertex, alone.
  CHECK(not_manifold({{0, 1, 2, 3}, {0, 1, 4, 5}}).ridges == std::vector<Simplex>{{0, 1}});
  CHECK(not_manifold({{0, 1, 2, 3}, {0, 4, 5, 6}}).vertices == std::vector<Vertex>{0});
  // A ring of tetrahedra around a vertex: its link is an annulus, with two circles for a boundary.
  std::vector<Simplex> ring;
  for (Vertex i = 0; i < 4; ++i) {
    const Vertex next = (i + 1) % 4;
    ring.push_back({8, i, next, i + 4});
    ring.push_back({8, next, i + 4, next + 4});
  }
  CHECK(not_manifold(ring).facets.empty());
  CHECK(not_manifold(ring).ridges.empty());
  CHECK(not_manifold(ring).vertices == std::vector<Vertex>{8});
  CHECK(parts({}) == 0);
  CHECK(not_manifold({{0, 1}, {1, 2}, {1, 3}}).facets == std::vector<Simplex>{{1}});
  CHECK(not_manifold({{0, 1}, {1, 2}}).vertices.empty());
}

TEST_CASE("orientations by sign and along facets") {
  const std::vector<Point> plane = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  CHECK(orientation_signs(plane, {{0, 1, 2}, {1, 2, 3}, {1, 3, 2}}) == std::vector<int>{1, -1, 1});
  const std::vector<Point> space = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(orientation_signs(space, {{0, 1, 2, 3}, {1, 0, 2, 3}}) == std::vector<int>{1, -1});
  CHECK(inconsistent_facets({{0, 1, 2}, {1, 3, 2}}).empty());
  CHECK(inconsistent_facets({{0, 1, 2}, {1, 2, 3}}) == std::vector<Simplex>{{1, 2}});
  CHECK(inconsistent_facets({{2, 0, 1}, {3, 2, 1}}).empty());
  CHECK(
      inconsistent_facets({{0, 1, 2}, {1, 2, 3}, {1, 2, 4}}).empty());  // of three nothing is said
  CHECK(inconsistent_facets({{0, 1}, {1, 2}}).empty());
  CHECK(inconsistent_facets({{0, 1}, {2, 1}}) == std::vector<Simplex>{{1}});
  CHECK(inconsistent_facets({{0, 1, 2, 3}, {1, 0, 2, 4}}).empty());
}

}  // namespace
}  // namespace circumspect::definition
