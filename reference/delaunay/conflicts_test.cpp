// Conflicts with solid and with ghost simplices. Book: Section 5.2.
#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {
namespace {

TEST_CASE("conflict: a solid triangle's open disk, and its ghosts' outer halfplanes") {
  //                     the triangle            beyond   on the line, inside and outside  within
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {2, -3}, {1, 0}, {5, 0}, {-1, 0}, {1, 1}});
  const Simplex ghost = {1, 0, kGhost};  // below the edge from (0, 0) to (4, 0)
  CHECK(is_in_conflict(points, ghost, 3));
  CHECK(is_in_conflict(points, ghost, 4));
  CHECK(!is_in_conflict(points, ghost, 5));
  CHECK(!is_in_conflict(points, ghost, 6));
  CHECK(!is_in_conflict(points, ghost, 7));
  CHECK(!is_in_conflict(points, ghost, 2));
  CHECK(is_in_conflict(points, {0, 1, 2}, 7));
  CHECK(is_in_conflict(points, {0, 1, 2}, 4));
  CHECK(!is_in_conflict(points, {0, 1, 2}, 3));
}

TEST_CASE("conflict: on a sphere the perturbation decides, for ghosts too") {
  // (0,0) comes first in lexicographic order, so its weight is the largest: it is in the disk.
  const PointSet square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(is_in_conflict(square, {1, 2, 3}, 0));
  CHECK(!is_in_conflict(square, {0, 1, 2}, 3));
  CHECK(is_in_conflict(square, {0, 1, 3}, 2));  // the diagonal without the first point is not there
  // The square as a facet of a pyramid: the ghosts of its two halves.
  const PointSet pyramid({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(is_in_conflict(pyramid, {1, 2, 3, kGhost}, 0));
  CHECK(is_in_conflict(pyramid, {2, 1, 3, kGhost}, 0));
  CHECK(!is_in_conflict(pyramid, {0, 1, 2, kGhost}, 3));
  CHECK(!is_in_conflict(pyramid, {1, 0, 2, kGhost}, 3));
  CHECK(is_in_conflict(pyramid, {0, 1, 3, kGhost}, 4) !=
        is_in_conflict(pyramid, {1, 0, 3, kGhost}, 4));
}

TEST_CASE("conflict: on a line the ghosts are the two sides beyond the ends") {
  const PointSet points({{0}, {2}, {1}, {3}, {-1}});
  REQUIRE(positively_oriented(points, {1, 0}) == Simplex{1, 0});
  const Simplex right = {kGhost, 1};  // in front of point 1, which the edge (1, 0) is behind
  const Simplex left = {0, kGhost};
  CHECK(is_in_conflict(points, right, 3));
  CHECK(!is_in_conflict(points, right, 2));
  CHECK(!is_in_conflict(points, right, 4));
  CHECK(is_in_conflict(points, left, 4));
  CHECK(!is_in_conflict(points, left, 3));
  CHECK(is_in_conflict(points, {1, 0}, 2));
  CHECK(!is_in_conflict(points, {1, 0}, 3));
}

// The ghost on the far side of each facet of a positively oriented simplex holds what lies strictly
// beyond the facet, nothing strictly on its inner side, and in its hyperplane the facet's own disk.
TEST_CASE("conflict: a ghost is its open halfspace and the disk of its facet") {
  for (const std::size_t d : {1U, 2U, 3U}) {
    CHECK(properties::holds("dimension " + std::to_string(d), [d] {
      const generators::PointsCase set = *generators::simplex_and_queries(d);
      const PointSet points(set.points, set.weights);
      const Configuration& configuration = points.configuration();
      const auto size = static_cast<std::size_t>(points.dimension()) + 1;
      const Simplex simplex = positively_oriented(points, generators::first_vertices(size));
      for (std::size_t place = 0; place < size; ++place) {
        const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
        const Simplex ghost = join(facet.reverse(), kGhost);
        for (auto q = static_cast<Vertex>(size); points.names(q); ++q) {
          const int inner = orientation(configuration, with_vertex_replaced(simplex, place, q));
          const bool expected =
              inner < 0 || (inner == 0 &&
                            perturbed_in_ball(configuration, axes_of(configuration, facet.vertices),
                                              facet.vertices, q) > 0);
          RC_ASSERT(is_in_conflict(points, ghost, q) == expected);
        }
      }
    }));
  }
}

TEST_CASE(
    "conflict: an even permutation of the simplex changes nothing, wherever the ghost stands") {
  CHECK(properties::holds([] {
    const generators::PointsCase set = *generators::simplex_and_queries(3);
    const PointSet points(set.points, set.weights);
    const auto size = static_cast<std::size_t>(points.dimension()) + 1;
    const Simplex simplex = positively_oriented(points, generators::first_vertices(size));
    const Simplex ghost = join(OrientedFacet::opposite(simplex, 0).reverse(), kGhost);
    Simplex other = generators::shuffled(ghost);
    if (is_odd_permutation(other) != is_odd_permutation(ghost)) std::swap(other[0], other[1]);
    for (auto q = static_cast<Vertex>(size); points.names(q); ++q) {
      RC_ASSERT(is_in_conflict(points, other, q) == is_in_conflict(points, ghost, q));
    }
  }));
}

}  // namespace
}  // namespace circumspect::delaunay
