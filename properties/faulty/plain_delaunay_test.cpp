// The predicates and the triangulator into which faults are planted.
#include "properties/faulty/plain_delaunay.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include <doctest/doctest.h>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/faulty/plain_predicates.hpp"

namespace circumspect::faulty {

// ---- Plain predicates ----
// Without a mistake, the plain predicates are the predicates: on numbers small enough that doubles
// are exact.

namespace {

// d + 2 of eight points in a row, for every row of a small table.
PointArray some_points(std::size_t dimension, std::size_t from, bool weighted) {
  constexpr double kNumbers[] = {0, 3, 1, 4, -1, 5, 9, 2, -6, 5, 3, 5, -8, 9, 7, 9, 3};
  PointArray points{dimension};
  for (std::size_t i = 0; i < dimension + 2; ++i) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      points.coordinates.push_back(kNumbers[(from + 3 * i + 5 * axis) % std::size(kNumbers)]);
    }
    if (weighted) points.weights.push_back(kNumbers[(from + 7 * i) % std::size(kNumbers)]);
  }
  return points;
}

bool repeats_a_point(const PointArray& points) {
  std::set<std::vector<double>> distinct;
  for (std::size_t i = 0; i < points.size(); ++i) {
    distinct.insert({points.point(i), points.point(i) + points.dimension});
  }
  return distinct.size() < points.size();
}

struct Signs {
  int orientation = 0;
  int in_ball = 0;
  bool operator==(const Signs&) const = default;
};

Signs signs(const PointArray& points, const Arithmetic& arithmetic) {
  const PointSet exact = exact_points(points);
  const PlainPredicates predicates(points, exact, arithmetic);
  std::vector<Vertex> simplex = every_index(points);
  const Vertex q = simplex.back();
  simplex.pop_back();
  const auto axes = exact.configuration().axes();
  return {predicates.orientation(axes, simplex), predicates.in_ball(axes, simplex, q)};
}

TEST_CASE("plain predicates without a mistake are right on small numbers") {
  std::size_t compared = 0;
  for (const std::size_t dimension : {1u, 2u, 3u}) {
    for (const bool weighted : {false, true}) {
      for (std::size_t from = 0; from < 17; ++from) {
        const PointArray points = some_points(dimension, from, weighted);
        if (repeats_a_point(points)) continue;
        const Signs exact = signs(points, {});
        if (exact.orientation == 0) continue;
        ++compared;
        for (const Numbers numbers : {Numbers::kFloat, Numbers::kDouble, Numbers::kLongDouble}) {
          CHECK(signs(points, {.numbers = numbers}) == exact);
        }
        CHECK(signs(points, {.numbers = Numbers::kDouble, .trusted_beyond = 1e9}) == exact);
        if (!weighted && exact.in_ball != 0) {
          CHECK(signs(points, {.by_circumcentre = true}) == exact);
        }
      }
    }
  }
  CHECK(compared > 40);
}

TEST_CASE("each mistake in arithmetic gives a wrong sign") {
  const PointArray small{2, {0, 0, 1e-3, 0, 0, 1e-3, 5e-4, 5e-4}};
  CHECK(signs(small, {}) == Signs{1, 1});
  CHECK(signs(small, {.in_ball_tolerance = 1e-10}).in_ball == 0);
  CHECK(signs(small, {.orientation_tolerance = 1e-5}).orientation == 0);
  const PointArray deep{3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 2, 2, 6}};
  CHECK(signs(deep, {}).in_ball < 0);
  CHECK(signs(deep, {.forgets_last_axis = true}).in_ball > 0);
  const PointArray clockwise{2, {0, 0, 0, 4, 4, 0, 1, 1}};
  CHECK(signs(clockwise, {}) == Signs{-1, 1});
}

// ---- Plain Delaunay ----
// Plain Bowyer–Watson without a mistake, and what each mistake does to a few points.

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
