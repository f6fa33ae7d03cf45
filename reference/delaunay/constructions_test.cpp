// Constructions on sets whose triangulation is known. Book: Definition 4.1, Figures 4.1 and 4.2.
#include <algorithm>
#include <stdexcept>

#include <doctest/doctest.h>

#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/lexicographic.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

// ---- The Delaunay triangulation from its definition, on sets whose triangulation is known ----

std::vector<Simplex> simplices(const std::vector<Point>& points,
                               const std::vector<Rational>& weights = {}) {
  return by_definition(PointSet(points, weights)).simplices();
}

TEST_CASE("by definition: of no point, one point, two points") {
  CHECK(by_definition(PointSet({})) == Triangulation(-1, {}));
  CHECK(by_definition(PointSet({{5, 5}})) == Triangulation(0, {{0}}));
  CHECK(by_definition(PointSet({{5, 5}, {0, 1}})) == Triangulation(1, {{0, 1}}));
}

TEST_CASE("by definition: points on a line are joined to their neighbours") {
  CHECK(simplices({{3}, {0}, {1}, {-2}}) == std::vector<Simplex>{{0, 2}, {1, 2}, {1, 3}});
  CHECK(simplices({{3, 6, 1}, {0, 0, 1}, {1, 2, 1}}) == std::vector<Simplex>{{0, 2}, {1, 2}});
}

TEST_CASE("by definition: the shorter diagonal of a kite, and never the flat triangle") {
  CHECK(simplices({{-2, 0}, {2, 0}, {0, 1}, {0, -1}}) ==
        std::vector<Simplex>{{0, 2, 3}, {1, 2, 3}});
  CHECK(simplices({{0, 0}, {1, 0}, {2, 0}, {1, 5}}) == std::vector<Simplex>{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE("by definition: a square is cut at its lexicographically smallest corner") {
  CHECK(simplices({{1, 1}, {0, 1}, {1, 0}, {0, 0}}) == std::vector<Simplex>{{0, 1, 3}, {0, 2, 3}});
  // Where the square lies in space changes nothing but the coordinates that decide.
  CHECK(simplices({{1, 7, 1}, {0, 7, 1}, {1, 7, 0}, {0, 7, 0}}) ==
        std::vector<Simplex>{{0, 1, 3}, {0, 2, 3}});
}

// Five points in space have two triangulations, of two and of three tetrahedra. Book: Figure 4.1.
TEST_CASE("by definition: two tetrahedra or three, as the apexes are far apart or near") {
  const std::vector<Point> flat = {{2, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {0, 0, 1}, {0, 0, -1}};
  CHECK(simplices(flat) == std::vector<Simplex>{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  std::vector<Point> tall = flat;
  tall[3] = {0, 0, 5};
  tall[4] = {0, 0, -5};
  CHECK(simplices(tall) == std::vector<Simplex>{{0, 1, 2, 3}, {0, 1, 2, 4}});
}

TEST_CASE("by definition: weights move the diagonal, and submerge a point") {
  const std::vector<Point> kite = {{-2, 0}, {2, 0}, {0, 1}, {0, -1}};
  CHECK(simplices(kite, {4, 4, 0, 0}) == std::vector<Simplex>{{0, 1, 2}, {0, 1, 3}});
  CHECK(simplices({{0}, {1}, {2}}, {0, 0, 0}) == std::vector<Simplex>{{0, 1}, {1, 2}});
  CHECK(simplices({{0}, {1}, {2}}, {0, -2, 0}) == std::vector<Simplex>{{0, 2}});
  // On the lower hull without being extreme: the perturbation of point 0 lowers the edge below it.
  CHECK(simplices({{0}, {1}, {2}}, {0, -1, 0}) == std::vector<Simplex>{{0, 2}});
}

// ---- The Delaunay subdivision as a lower hull, on sets whose answer is known ----

using Faces = std::vector<Face>;

TEST_CASE("lifted hull: a grid of squares is its own subdivision") {
  std::vector<Point> grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) grid.push_back({x, y});
  }
  const PointSet points(grid);
  for (const PolyhedralComplex& subdivision :
       {delaunay_subdivision(points), delaunay_subdivision_by_definition(points)}) {
    CHECK(subdivision.cells() == Faces{{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}, {4, 5, 7, 8}});
    CHECK(subdivision.faces(1).size() == 12);
    CHECK(subdivision.faces(0).size() == 9);
  }
  CHECK(lifted_hull(points) == by_definition(points));
}

TEST_CASE("lifted hull: all points on one sphere are one cell") {
  const PointSet points({{3, 4}, {-3, 4}, {5, 0}, {0, -5}, {-4, -3}});
  CHECK(delaunay_subdivision(points).cells() == Faces{{0, 1, 2, 3, 4}});
  CHECK(delaunay_subdivision_by_definition(points).cells() == Faces{{0, 1, 2, 3, 4}});
  CHECK(lifted_hull(points).simplices().size() == 3);
}

TEST_CASE("lifted hull: a cell may face up or stand upright, and is none then") {
  // Three points on the x-axis: the facets of conv S+ over the axis are vertical.
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {1, 5}, {1, -5}});
  CHECK(delaunay_subdivision(points).cells() == Faces{{0, 1, 3}, {0, 1, 4}, {1, 2, 3}, {1, 2, 4}});
}

TEST_CASE("lifted hull: no point, one, two, and points of a plane in space") {
  CHECK(delaunay_subdivision(PointSet({})).dimension() == -1);
  CHECK(lifted_hull(PointSet({})) == Triangulation(-1, {}));
  CHECK(lifted_hull(PointSet({{1, 2, 3}})) == Triangulation(0, {{0}}));
  CHECK(lifted_hull(PointSet({{1, 2, 3}, {4, 4, 4}})) == Triangulation(1, {{0, 1}}));
  const PointSet square({{0, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1}});  // on x = y
  CHECK(delaunay_subdivision(square).dimension() == 2);
  CHECK(delaunay_subdivision(square).cells() == Faces{{0, 1, 2, 3}});
}

TEST_CASE("lifted hull: weights submerge points, or leave them on a face without being extreme") {
  const std::vector<Point> line = {{0}, {1}, {2}};
  const auto with_middle_weight = [&](const Rational& weight) {
    return PointSet(line, {0, weight, 0});
  };
  CHECK(delaunay_subdivision(with_middle_weight(-2)).cells() == Faces{{0, 2}});  // above the hull
  CHECK(delaunay_subdivision(with_middle_weight(-1)).cells() == Faces{{0, 1, 2}});  // on it
  CHECK(delaunay_subdivision(with_middle_weight(0)).cells() == Faces{{0, 1}, {1, 2}});
  CHECK(delaunay_subdivision(with_middle_weight(-1)).faces(0) == Faces{{0}, {2}});
  // Pulling the first point down leaves the middle one above.
  CHECK(lifted_hull(with_middle_weight(-1)) == Triangulation(1, {{0, 2}}));
  CHECK(lifted_hull(with_middle_weight(-1)) == by_definition(with_middle_weight(-1)));
}

// ---- Gift-wrapping and its seeds, on sets whose answer is known ----

TEST_CASE("gift-wrapping: the apex is in front, and nearest in the pencil of circles") {
  const PointSet points({{0, 0}, {4, 0}, {2, 9}, {2, 1}, {2, 5}, {2, -1}, {6, 0}});
  const std::vector<std::size_t> axes = {0, 1};
  const OrientedFacet edge = OrientedFacet::of({0, 1});
  CHECK(apex_of_facet(points, axes, edge, {2, 3, 4, 5, 6}) == 3);
  CHECK(apex_of_facet(points, axes, edge, {2, 4, 5, 6}) == 4);
  CHECK(apex_of_facet(points, axes, edge.reverse(), {2, 3, 4, 5, 6}) == 5);
  CHECK_FALSE(apex_of_facet(points, axes, edge, {0, 1, 5, 6}).has_value());
}

// Figure 3.14: cocircular points on which gift-wrapping without perturbation goes wrong.
TEST_CASE("gift-wrapping: eight cospherical points of a cube, and six of an octahedron") {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1, (i >> 1) & 1, i >> 2});
  const PointSet cube(corners);
  CHECK(gift_wrapping(cube) == by_definition(cube));
  CHECK(gift_wrapping_by_cells(cube) == by_definition(cube));
  CHECK(gift_wrapping_cells(cube).cells() == std::vector<Face>{{0, 1, 2, 3, 4, 5, 6, 7}});
  const PointSet octahedron({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  CHECK(gift_wrapping(octahedron).simplices().size() == 4);
  CHECK(gift_wrapping(octahedron) == by_definition(octahedron));
}

TEST_CASE("gift-wrapping: no point, one, points on a line, submerged points") {
  for (const auto algorithm :
       {+[](const PointSet& points) { return gift_wrapping(points); }, gift_wrapping_by_cells}) {
    CHECK(algorithm(PointSet({})) == Triangulation(-1, {}));
    CHECK(algorithm(PointSet({{1, 2}})) == Triangulation(0, {{0}}));
    CHECK(algorithm(PointSet({{3, 3}, {1, 1}, {2, 2}})) == Triangulation(1, {{0, 2}, {1, 2}}));
    CHECK(algorithm(PointSet({{3}, {1}, {2}}, {0, 0, -5})) == Triangulation(1, {{0, 1}}));
  }
}

TEST_CASE("gift-wrapping: the nearest-neighbour seed (Section 5.6)") {
  const PointSet points({{0, 0, 0}, {9, 1, 0}, {2, 0, 1}, {1, 3, 0}, {1, 1, 7}, {-8, 2, 2}});
  CHECK(nearest_neighbour_seed(points) == Simplex{0, 2, 3});
  CHECK(gift_wrapping(points, {0, 2, 3}) == by_definition(points));
  CHECK(nearest_neighbour_seed(PointSet({{5}, {9}, {1}})) == Simplex{0});
}

TEST_CASE("gift-wrapping: facets that no triangulation has together are found out") {
  const PointSet points({{-9, 0}, {0, -1}, {8, 0}, {0, 1}});
  UnfinishedFacets crossing;
  crossing.add(OrientedFacet::of({1, 3}));
  crossing.add(OrientedFacet::of({0, 2}));
  crossing.add(OrientedFacet::of({2, 0}));
  CHECK_THROWS_AS(gift_wrap(points, {0, 1}, crossing, all_vertices(points)), std::logic_error);
}

// ---- The lexicographic triangulation of sets small enough to do by hand ----

TEST_CASE("lexicographic: no point, one, points on a line in any order") {
  CHECK(lexicographic(PointSet({})) == Triangulation(-1, {}));
  CHECK(lexicographic(PointSet({{4, 4}})) == Triangulation(0, {{0}}));
  CHECK(lexicographic(PointSet({{3, 3}, {1, 1}, {2, 2}})) == Triangulation(1, {{0, 2}, {1, 2}}));
}

TEST_CASE("lexicographic: each point is joined to the edges it sees") {
  const PointSet points({{0, 0}, {1, 3}, {2, -2}, {3, 0}, {9, 0}});
  CHECK(lexicographic(points) == Triangulation(2, {{0, 1, 2}, {1, 2, 3}, {1, 3, 4}, {2, 3, 4}}));
}

TEST_CASE(
    "lexicographic: a point that leaves the line is joined to all edges, in the plane to all") {
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {3, 1}});
  CHECK(lexicographic(points) == Triangulation(2, {{0, 1, 3}, {1, 2, 3}}));
  const PointSet raised({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}, {4, 0, 1}, {5, 0, 0}});
  CHECK(lexicographic(raised) == Triangulation(3, {{0, 1, 3, 4}, {1, 2, 3, 4}, {2, 3, 4, 5}}));
}

TEST_CASE("lexicographic: hull facets coplanar with the new point are not seen") {
  const PointSet square({{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}});
  CHECK(lexicographic(square) == Triangulation(2, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}}));
}

// ---- The least-vertex triangulation of polyhedral complexes that are not Delaunay subdivisions,
// too ----

TEST_CASE("least vertex: a square, by its lexicographically minimum vertex") {
  const PointSet points({{1, 1}, {1, 0}, {0, 1}, {0, 0}});
  const PolyhedralComplex square(points, 2, {{0, 1, 2, 3}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(points, square) == Triangulation(2, {{0, 1, 3}, {0, 2, 3}}));
}

TEST_CASE("least vertex: two cubes triangulate their common square alike (Figure 4.4)") {
  std::vector<Point> corners;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 2; ++y) {
      for (int z = 0; z < 2; ++z) corners.push_back({x, y, z});
    }
  }
  const PointSet points(corners);
  const PolyhedralComplex cubes(points, 3, {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}},
                                facets_by_wrapping);
  const Triangulation triangulation = least_vertex_triangulation(points, cubes);
  CHECK(triangulation.simplices().size() == 12);
  // The diagonal of the square adjoins its least vertex; both cubes have its two triangles.
  const auto apexes = apexes_by_facet(triangulation);
  CHECK(apexes.at({4, 5, 7}).size() == 2);
  CHECK(apexes.at({4, 6, 7}).size() == 2);
  CHECK(apexes.count({4, 5, 6}) == 0);
}

TEST_CASE("least vertex: a pentagon that no circle passes through") {
  const PointSet points({{5, 0}, {6, 3}, {1, 9}, {-4, 2}, {-3, -1}});
  const PolyhedralComplex pentagon(points, 2, {{0, 1, 2, 3, 4}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(points, pentagon) ==
        Triangulation(2, {{0, 1, 3}, {0, 3, 4}, {1, 2, 3}}));
}

TEST_CASE("least vertex: points that are not extreme remain unused") {
  // On a line, the points 1 and 2 lie between the ends 0 and 3.
  const PointSet line({{0}, {1}, {2}, {3}});
  const PolyhedralComplex segment(line, 1, {{0, 1, 2, 3}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(line, segment) == Triangulation(1, {{0, 3}}));
  // In a triangle, on an edge.
  const PointSet points({{0, 0}, {0, 4}, {3, 0}, {0, 2}});
  const PolyhedralComplex triangle(points, 2, {{0, 1, 2, 3}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(points, triangle) == Triangulation(2, {{0, 1, 2}}));
}

TEST_CASE("least vertex: the empty complex and a point") {
  const PointSet none(std::vector<Point>{});
  CHECK(least_vertex_triangulation(none, PolyhedralComplex(none, -1, {}, facets_by_wrapping)) ==
        Triangulation(-1, {}));
  const PointSet one(std::vector<Point>{{7}});
  CHECK(least_vertex_triangulation(one, PolyhedralComplex(one, 0, {{0}}, facets_by_wrapping)) ==
        Triangulation(0, {{0}}));
}

}  // namespace

}  // namespace circumspect::delaunay
