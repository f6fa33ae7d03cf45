// The claim `convex-hull`, by lemma and by definition: what each kind of fault is called, and the
// forms in which a hull is listed.
#include "oracle/judge/convex_hull/judge_convex_hull.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "oracle/judge/definition/convex_hull.hpp"

namespace circumspect::check {
namespace {

using Tallies = std::map<Rule, std::size_t>;

// The tallies of both ways, which are the same.
Tallies broken(const std::vector<Point>& points, const std::vector<Simplex>& facets,
               const HullDemands& demands = {}, bool oriented = false) {
  const ExactMesh mesh{PointSet(points), facets};
  Tallies of_both[2];
  for (const bool by_definition : {false, true}) {
    const Verdict verdict = judge_convex_hull(mesh, demands, oriented, by_definition, 0);
    for (const auto& [rule, tally] : verdict.tallies()) of_both[by_definition][rule] = tally.count;
  }
  CHECK(of_both[0] == of_both[1]);
  return of_both[0];
}

const std::vector<Point> kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 0}};

// In their cyclic order, a vertex a row.
std::vector<Simplex> cycle(const Simplex& vertices) {
  std::vector<Simplex> rows;
  for (const Vertex v : vertices) rows.push_back({v});
  return rows;
}

TEST_CASE("in the plane a hull is edges, or a vertex a row") {
  CHECK(broken(kSquare, {{0, 1}, {2, 1}, {2, 3}, {0, 3}}).empty());
  CHECK(broken(kSquare, cycle({0, 1, 2, 3})).empty());
  CHECK(broken(kSquare, cycle({3, 2, 1, 5, 0})).empty());
  CHECK(broken(kSquare, cycle({0, 2, 1, 3})) ==
        Tallies{{Rule::kFacetNotSupporting, 2}, {Rule::kOverlap, 1}});
  CHECK(broken(kSquare, cycle({0, 1, 2})) == Tallies{{Rule::kFacetNotSupporting, 1}});
  CHECK(broken(kSquare, cycle({0, 1, 2, 3, 0, 1, 2, 3})) == Tallies{{Rule::kDuplicateSimplex, 4}});
}

// The points inside are at one end and the other in turn, and there are many facets between these
// on both sides: a walk from one point to the next takes too long, and another search goes on.
TEST_CASE("points inside a hull of many facets are found, though each is far from the last") {
  std::vector<Point> points;
  std::vector<Simplex> vertices;
  for (int x = 0; x < 300; ++x) points.push_back({x, x * (x - 300)});
  for (int x = 300; x > 0; --x) points.push_back({x, x * (300 - x)});
  for (Vertex v = 0; v < 600; ++v) vertices.push_back({v});
  for (int i = 0; i < 150; ++i) points.push_back({i % 2 == 0 ? 1 : 299, Rational(i - 75, 2)});
  const auto tallies = [&] {
    return judge_convex_hull({PointSet(points), vertices}, {}, false, false, 0).tallies();
  };
  CHECK(tallies().empty());
  points.back() = {299, 300};
  REQUIRE(tallies().size() == 1);
  CHECK(tallies().contains(Rule::kFacetNotSupporting));
}

TEST_CASE("points of the boundary may be vertices or not, unless more is demanded") {
  const std::vector<Simplex> without = cycle({0, 1, 2, 3});
  const std::vector<Simplex> with = cycle({0, 5, 1, 2, 3});
  CHECK(broken(kSquare, with).empty());
  CHECK(broken(kSquare, without, {.only_extreme = true}).empty());
  CHECK(broken(kSquare, with, {.all_boundary_points = true}).empty());
  CHECK(broken(kSquare, without, {.all_boundary_points = true}) ==
        Tallies{{Rule::kBoundaryPointLeftOut, 1}});
  CHECK(broken(kSquare, with, {.only_extreme = true}) == Tallies{{Rule::kVertexNotExtreme, 1}});
}

TEST_CASE("what is missing is named by where it begins, and all of it if nothing is listed") {
  CHECK(broken(kSquare, {{0, 1}, {1, 2}, {2, 3}}) == Tallies{{Rule::kHullUncovered, 2}});
  CHECK(broken(kSquare, {}) == Tallies{{Rule::kHullUncovered, 1}});
}

TEST_CASE("a point that was left out lies beyond the facets that it should have been in") {
  CHECK(broken({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {9, 2}}, cycle({0, 1, 2, 3})) ==
        Tallies{{Rule::kFacetNotSupporting, 1}});
}

TEST_CASE("a facet that does not support has the first point on each of its sides for a witness") {
  const PointSet points({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}});
  CHECK(definition::on_both_sides(points, {0, 2}) == Simplex{1, 3});
  CHECK(definition::on_both_sides(points, {2, 0}) == Simplex{1, 3});
  CHECK(definition::on_both_sides(points, {4, 1}) == Simplex{0, 2});
  CHECK(!definition::on_both_sides(points, {0, 1}));
  CHECK(!definition::on_both_sides(points, {3, 2}));
}

TEST_CASE("a set that lies in a plane has a hull there") {
  const std::vector<Point> flat = {{0, 0, 1}, {4, 0, 5}, {4, 4, 9}, {0, 4, 5}};
  CHECK(broken(flat, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}).empty());
  CHECK(broken(flat, {{0, 1, 2}, {0, 2, 3}}) == Tallies{{Rule::kWrongDimension, 2}});
  CHECK(broken({{1, 1}, {3, 3}, {2, 2}}, {{0}, {1}}).empty());
  CHECK(broken({{1, 1}, {3, 3}, {2, 2}}, {{0}, {2}}) == Tallies{{Rule::kFacetNotSupporting, 1}});
  CHECK(broken({{1, 1}, {3, 3}, {2, 2}}, {{0}, {1}, {2}}) ==
        Tallies{{Rule::kFacetNotSupporting, 1}});
}

TEST_CASE("a square wound twice around an apex has all its edges in two facets") {
  // Corners and the middles of the edges from the apex to them: the second round is on the first.
  const std::vector<Point> points = {{4, 4, 0}, {-4, 4, 0}, {-4, -4, 0}, {4, -4, 0}, {0, 0, 8},
                                     {2, 2, 4}, {-2, 2, 4}, {-2, -2, 4}, {2, -2, 4}};
  std::vector<Simplex> facets;
  const Simplex round = {0, 1, 2, 3, 5, 6, 7, 8};
  for (std::size_t i = 0; i < round.size(); ++i) {
    facets.push_back({4, round[i], round[(i + 1) % round.size()]});
  }
  CHECK(broken(points, facets).contains(Rule::kOverlap));
}

TEST_CASE("a pentagram turns to the left at each vertex, and only a ray sees that it winds twice") {
  const std::vector<Point> star = {{4, 0}, {1, 4}, {-3, 2}, {-3, -2}, {1, -4}};
  CHECK(broken(star, cycle({0, 1, 2, 3, 4})).empty());
  // However they are numbered: the first three points say from where the facets are seen, and from
  // the middle of the star all of them look convex.
  Simplex number = {0, 1, 2, 3, 4};
  do {
    std::vector<Point> renumbered(star.size());
    Simplex around;
    for (const std::size_t v : {0, 2, 4, 1, 3}) around.push_back(number[v]);
    for (std::size_t v = 0; v < star.size(); ++v) {
      renumbered[static_cast<std::size_t>(number[v])] = star[v];
    }
    CHECK(broken(renumbered, cycle(around)).at(Rule::kFacetNotSupporting) == 5);
    // In whatever order the edges are listed: the ray through the first meets the third or fourth.
    for (const std::size_t step : {2, 3}) {
      std::vector<Simplex> edges;
      for (std::size_t i = 0; i < 5; ++i) {
        const std::size_t from = i * step % 5;
        edges.push_back({around[from], around[(from + 1) % 5]});
      }
      CHECK(broken(renumbered, edges).at(Rule::kFacetNotSupporting) == 5);
    }
  } while (std::next_permutation(number.begin(), number.end()));
}

TEST_CASE("facets are oriented alike if that is demanded") {
  CHECK(broken(kSquare, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {}, true).empty());
  CHECK(broken(kSquare, {{0, 1}, {2, 1}, {2, 3}, {3, 0}}, {}, true) ==
        Tallies{{Rule::kNotOriented, 2}});
}

TEST_CASE("what cannot be a list of facets is refused, with what to do") {
  const auto fault = [](const std::vector<Point>& points, const std::vector<Simplex>& simplices) {
    return fault_of_hull(in_rows({PointSet(points), simplices}));
  };
  CHECK(fault(kSquare, {{0, 1, 2}, {0, 2, 3}}) ==
        "expected the facets of a hull, each of 2 vertices, found simplices of 3 vertices: list "
        "the boundary alone, or ask --claim triangulation of the mesh");
  CHECK(fault(kSquare, {{0, 1}}) == "");
  CHECK(fault({{1, 1}, {2, 3}}, {{0}, {1}}) == "");
  CHECK(fault({{1, 1}}, {}) ==
        "expected at least two points for the claim convex-hull, found 1: one point has no "
        "boundary");
}

}  // namespace
}  // namespace circumspect::check
