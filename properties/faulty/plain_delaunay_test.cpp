// Plain Bowyer–Watson without a mistake, and what each mistake does to a few points.
#include "properties/faulty/plain_delaunay.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "properties/faulty/plain_predicates.hpp"

namespace circumspect::faulty {
namespace {

SimplexArray in_order(SimplexArray simplices) {
  for (auto& simplex : simplices) std::sort(simplex.begin(), simplex.end());
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

SimplexArray made(const PointArray& points, const Mistakes& mistakes = {}) {
  return in_order(plain_delaunay(points, mistakes));
}

// Generic: no four on a circle, no three on a line; the last three points outside the hull so far.
const PointArray kPlane{2, {0, 0, 4, 1, 1, 5, 2, 2, 7, 7, -3, 2, 5, -6}};
const PointArray kSpace{3, {0, 0, 0, 6, 1, 0, 1, 7, 1, 0, 1, 8, 2, 2, 3, 9, 9, 7, -4, 3, -5}};
// On one line and in one plane of space.
const PointArray kLine{3, {0, 0, 0, 2, 4, 6, 1, 2, 3, -1, -2, -3}};
const PointArray kFlat{3, {0, 0, 1, 4, 1, 1, 1, 5, 1, 2, 2, 1, 7, 7, 1}};

TEST_CASE("without a mistake it is the Delaunay triangulation, in any flat, walking or not") {
  for (const PointArray& points :
       {kPlane, kSpace, kLine, kFlat, PointArray{2, {1, 2}}, PointArray{3, {}}}) {
    CAPTURE(points.coordinates);
    const SimplexArray right = in_order(right_answer(points));
    CHECK(made(points) == right);
    CHECK(made(points, {.search = Search::kWalkThenNeighbors}) == right);
    CHECK(made(points, {.arithmetic = {.numbers = Numbers::kDouble}}) == right);
  }
}

TEST_CASE("with weights it leaves out what is submerged, unless it is told to keep it") {
  PointArray weighted = kPlane;
  weighted.weights = {0, 0, 0, -20, 0, 0, 0};
  const SimplexArray right = in_order(right_answer(weighted));
  const auto has_3 = [](const auto& simplex) {
    return std::count(simplex.begin(), simplex.end(), 3);
  };
  REQUIRE(std::none_of(right.begin(), right.end(), has_3));
  CHECK(made(weighted) == right);
  const SimplexArray kept = made(weighted, {.keeps_submerged_points = true});
  CHECK(std::any_of(kept.begin(), kept.end(), has_3));

  weighted.coordinates = {0, 0, 8, 0, 0, 8, 2, 2, 3, 2};
  weighted.weights = {0, 0, 0, 0, 10};
  const SimplexArray without = made(weighted);
  REQUIRE(std::none_of(without.begin(), without.end(), has_3));
  const SimplexArray with = made(weighted, {.never_removes_vertices = true});
  CHECK(std::any_of(with.begin(), with.end(), has_3));
}

TEST_CASE("only splitting, it is a triangulation that is not Delaunay") {
  const SimplexArray split = made(kPlane, {.only_splits = true});
  CHECK(split.size() == right_answer(kPlane).size());
  CHECK(split != in_order(right_answer(kPlane)));
}

TEST_CASE("each mistake changes the mesh") {
  const SimplexArray plane = in_order(right_answer(kPlane));
  CHECK(made(kPlane, {.no_ghosts = true}) != plane);
  CHECK(made(kPlane, {.search = Search::kWalkThenNeighbors, .most_steps = 0}) != plane);
  CHECK(made(kPlane, {.search = Search::kWalkThenNeighbors, .most_layers = 0}) != plane);
  // A point on an edge of the hull, and one beyond it on the same line.
  const PointArray on_the_hull{2, {0, 0, 4, 0, 0, 4, 2, 0, 9, 0}};
  const SimplexArray right = in_order(right_answer(on_the_hull));
  CHECK(made(on_the_hull) == right);
  CHECK(made(on_the_hull, {.ghosts_forget_their_plane = true}) != right);
  CHECK(made(on_the_hull, {.ghosts_take_their_plane = true}) != right);
  // Points of a circle, one on the line of an edge.
  const PointArray square{2, {0, 0, 2, 0, 2, 2, 1, 0, 0, 2, 1, 2}};
  CHECK(made(square, {.tie = Tie::kYes}) != made(square));
  CHECK(made(square, {.tie = Tie::kByVertexOrder}) != made(square));
}

}  // namespace
}  // namespace circumspect::faulty
