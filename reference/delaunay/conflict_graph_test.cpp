// The conflict graph, by hand. Book: Section 5.4.
#include "reference/delaunay/conflict_graph.hpp"

#include <doctest/doctest.h>

#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/dictionary.hpp"

namespace circumspect::delaunay {
namespace {

TEST_CASE("conflict graph: inside, outside, and in a triangle that is split twice") {
  const PointSet points({{0, 0}, {9, 0}, {0, 9}, {3, 3}, {1, 2}, {20, 20}});
  BowyerWatson algorithm(points);
  REQUIRE(sorted(algorithm.first_simplex()) == Simplex{0, 1, 2});
  ConflictGraph graph(points, algorithm.dictionary(), {3, 4, 5}, algorithm.statistics());
  CHECK(sorted(graph.conflict_of(4).value()) == Simplex{0, 1, 2});
  CHECK(sorted(graph.conflict_of(5).value()) == Simplex{kGhost, 1, 2});
  graph.update(algorithm.insert(3, *graph.conflict_of(3)));
  CHECK(!graph.conflict_of(3));
  CHECK(sorted(graph.conflict_of(4).value()) == Simplex{0, 2, 3});
  CHECK(sorted(graph.conflict_of(5).value()) == Simplex{kGhost, 1, 2});
  graph.update(algorithm.insert(5, *graph.conflict_of(5)));
  CHECK(sorted(graph.conflict_of(4).value()) == Simplex{0, 2, 3});
  CHECK(algorithm.statistics().conflicts_created == 4);
}

TEST_CASE("conflict graph: a vertex outside comes inside") {
  const PointSet points({{0, 0}, {9, 0}, {0, 9}, {8, 8}, {20, 20}});
  BowyerWatson algorithm(points);
  ConflictGraph graph(points, algorithm.dictionary(), {3, 4}, algorithm.statistics());
  CHECK(is_ghost(graph.conflict_of(3).value()));
  graph.update(algorithm.insert(4, *graph.conflict_of(4)));
  CHECK(sorted(graph.conflict_of(3).value()) == Simplex{1, 2, 4});
}

TEST_CASE("conflict graph: submerged from the start, or by an insertion") {
  const PointSet points({{0, 0}, {9, 0}, {0, 9}, {2, 2}, {3, 3}, {1, 1}}, {0, 0, 0, 60, 0, -99});
  BowyerWatson algorithm(points);
  ConflictGraph graph(points, algorithm.dictionary(), {3, 4, 5}, algorithm.statistics());
  CHECK(!graph.conflict_of(5));
  CHECK(graph.conflict_of(4));
  graph.update(algorithm.insert(3, *graph.conflict_of(3)));
  CHECK(!graph.conflict_of(4));
}

}  // namespace
}  // namespace circumspect::delaunay
