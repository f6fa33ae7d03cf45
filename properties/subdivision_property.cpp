// D4: the Delaunay subdivision is the projection of the lower lifted hull, and the canonical
// triangulation its least-vertex triangulation. D6: sizes. Book: Sections 4.1 and 4.2.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "kernel/predicates/in_ball.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;

PointSet any_labelled_set(std::size_t d, std::size_t max_points) {
  const PointsCase set = *generators::any_case(d, max_points);
  return PointSet(set.points, set.weights);
}

int cases(std::size_t d) { return d >= 5 ? 15 : d == 4 ? 50 : 200; }

bool includes(const Face& whole, const Face& part) {
  return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

TEST_CASE(
    "D4 three constructions of the subdivision agree (Section 4.2, Exercise 4 of Chapter 5)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(d);
    std::size_t not_simplicial = 0;
    CHECK(holds("one Delaunay subdivision", cases(d), [&] {
      const PointSet points = any_labelled_set(d, d >= 4 ? 8 : 10);
      const PolyhedralComplex expected = delaunay::delaunay_subdivision_by_definition(points);
      RC_ASSERT(delaunay::delaunay_subdivision(points) == expected);
      RC_ASSERT(delaunay::gift_wrapping_cells(points) == expected);
      not_simplicial += expected.is_simplicial() ? 0u : 1u;
    }));
    if (d <= 3) CHECK(occurs(not_simplicial, 6));
  }
}

TEST_CASE("D2 the least-vertex triangulation of the lifted hull is canonical (Section 4.2)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(d);
    CHECK(holds("lifted hull, least vertex", cases(d), [d] {
      const PointSet points = any_labelled_set(d, d >= 4 ? 8 : 10);
      const Triangulation expected = delaunay::by_definition(points);
      RC_ASSERT(delaunay::lifted_hull(points) == expected);
      RC_ASSERT(delaunay::lifted_hull_by_definition(points) == expected);
    }));
  }
}

// Cells meet in shared faces; a facet has one cell or two; a convex complex is a ball, so its face
// numbers alternate to 1.
void assert_polyhedral_complex(const PolyhedralComplex& complex) {
  const std::vector<Face> cells = complex.cells();
  std::set<Face> faces;
  long euler_characteristic = 0;
  for (int j = 0; j <= complex.dimension(); ++j) {
    faces.insert(complex.faces(j).begin(), complex.faces(j).end());
    euler_characteristic += (j % 2 == 0 ? 1 : -1) * static_cast<long>(complex.faces(j).size());
  }
  RC_ASSERT(euler_characteristic == 1);
  for (const Face& a : cells) {
    for (const Face& b : cells) {
      Face shared;
      std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
      RC_ASSERT(shared.empty() || faces.count(shared) == 1);
    }
  }
  std::map<Face, int> cells_at;
  for (const Face& cell : cells) {
    for (const Face& facet : complex.facets_of(cell)) ++cells_at[facet];
  }
  for (const auto& [facet, count] : cells_at) RC_ASSERT(count <= 2);
}

TEST_CASE("D4 the subdivision is a polyhedral complex that holds every canonical simplex") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("the subdivision", 150, [d] {
      const PointSet points = any_labelled_set(d, 12);
      RC_PRE(!points.empty());
      const PolyhedralComplex complex = delaunay::delaunay_subdivision(points);
      assert_polyhedral_complex(complex);
      const std::vector<Face> cells = complex.cells();
      const Triangulation canonical = delaunay::bowyer_watson(points);
      for (const Simplex& simplex : canonical.simplices()) {
        const auto around = std::count_if(
            cells.begin(), cells.end(), [&](const Face& cell) { return includes(cell, simplex); });
        RC_ASSERT(around == 1);
      }
    }));
  }
}

TEST_CASE("D10 the canonical vertices are the vertices of the subdivision (Sections 4.2, 5.2)") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    std::size_t not_extreme = 0;
    CHECK(holds("points on the lower hull that are not extreme are not vertices", 300, [&] {
      const PointSet points = any_labelled_set(d, 10);
      RC_PRE(!points.empty());
      const PolyhedralComplex complex = delaunay::delaunay_subdivision(points);
      std::set<Face> vertices;
      const Triangulation canonical = delaunay::by_definition(points);
      for (const Simplex& simplex : canonical.simplices()) {
        for (const Vertex v : simplex) vertices.insert({v});
      }
      RC_ASSERT(std::vector<Face>(vertices.begin(), vertices.end()) == complex.faces(0));
      for (const Face& cell : complex.cells()) {
        not_extreme += complex.vertices_of(cell).size() < cell.size() ? 1u : 0u;
      }
    }));
    CHECK(occurs(not_extreme));
  }
}

TEST_CASE("D4 no lifted point is below a cell's plane, those of the cell are on it (Section 4.2)") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("witness planes of cells", 150, [d] {
      const PointSet points = any_labelled_set(d, 12);
      const PolyhedralComplex complex = delaunay::delaunay_subdivision(points);
      for (const Face& cell : complex.cells()) {
        const Simplex basis = flat_through(points, cell).basis;
        for (Vertex q = 0; points.names(q); ++q) {
          const int below = in_ball(points.configuration(), basis, q);
          RC_ASSERT(below <= 0);
          RC_ASSERT((below == 0) == contains(cell, q));
        }
      }
    }));
  }
}

TEST_CASE(
    "D4 the subdivision is simplicial iff the Delaunay triangulation is unique (Theorem 4.4)") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("simplicial subdivisions", 150, [d] {
      const PointsCase set = *generators::unweighted(generators::any_point_set(d, 9));
      const PointSet points(set.points);
      RC_PRE(!points.empty());
      const PolyhedralComplex complex = delaunay::delaunay_subdivision(points);
      const Triangulation canonical = delaunay::bowyer_watson(points);
      RC_ASSERT(complex.is_simplicial() ==
                !delaunay::cospherical_points_of_an_empty_ball(points, canonical).has_value());
      if (complex.is_simplicial()) RC_ASSERT(complex.cells() == canonical.simplices());
    }));
  }
}

// Numbers of simplices of a three-dimensional triangulation, and of its vertices on the boundary.
struct Sizes {
  long vertices, edges, triangles, tetrahedra, hull_vertices;
};

Sizes sizes_of(const Triangulation& triangulation) {
  std::set<Vertex> vertices;
  std::set<Vertex> on_hull;
  std::set<Simplex> edges;
  const auto apexes = apexes_by_facet(triangulation);
  for (const auto& [triangle, apex] : apexes) {
    vertices.insert(triangle.begin(), triangle.end());
    if (apex.size() == 1) on_hull.insert(triangle.begin(), triangle.end());
    for (std::size_t place = 0; place < 3; ++place) edges.insert(facet_opposite(triangle, place));
  }
  return {static_cast<long>(vertices.size()), static_cast<long>(edges.size()),
          static_cast<long>(apexes.size()), static_cast<long>(triangulation.simplices().size()),
          static_cast<long>(on_hull.size())};
}

TEST_CASE("D6 the bounds of Section 4.1 on tetrahedra, triangles and edges") {
  std::size_t tight = 0;
  CHECK(holds("sizes", 400, [&] {
    const PointSet points = any_labelled_set(3, 14);
    RC_PRE(points.dimension() == 3);
    const Sizes size = sizes_of(delaunay::bowyer_watson(points));
    const long n = size.vertices;
    RC_ASSERT(2 * size.tetrahedra <= n * n - 3 * n - 2);
    RC_ASSERT(size.triangles <= n * n - 3 * n);
    RC_ASSERT(2 * size.edges <= n * n - n);
    RC_ASSERT(size.tetrahedra == size.edges - n - size.hull_vertices + 3);
    tight += n > 5 && 2 * size.edges == n * n - n ? 1u : 0u;
  }));
  CHECK(occurs(tight));  // on the moment curve every pair is an edge
}

// a points on one of two skew lines and b on the other, at distinct integer places.
PointSet on_skew_lines(const std::set<long>& first, const std::set<long>& second) {
  std::vector<Point> points;
  for (const long t : first) points.push_back({Rational(t), Rational(1 - t), 0});
  for (const long t : second) points.push_back({Rational(2 * t), Rational(t), 1});
  return PointSet(points);
}

TEST_CASE("D6 points on two skew lines have (a-1)(b-1) tetrahedra (Section 4.1, Figure 4.2)") {
  CHECK(holds("skew lines", 150, [] {
    const auto some_places = [] {
      const auto count = *rc::gen::inRange<std::size_t>(2, 8);
      return *rc::gen::unique<std::set<long>>(count, generators::integer_within(20));
    };
    const std::set<long> first = some_places();
    const std::set<long> second = some_places();
    const PointSet points = on_skew_lines(first, second);
    const Triangulation canonical = delaunay::lifted_hull(points);
    RC_ASSERT(canonical.simplices().size() == (first.size() - 1) * (second.size() - 1));
    RC_ASSERT(canonical == delaunay::bowyer_watson(points));
  }));
}

}  // namespace
}  // namespace circumspect::properties
