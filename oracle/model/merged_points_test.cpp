// What is left of equal points, and what the user calls it; indices at the ends of 64 bits.
#include "oracle/model/merged_points.hpp"

#include <limits>

#include <doctest/doctest.h>

namespace circumspect {
namespace {

constexpr Vertex kLeast = std::numeric_limits<Vertex>::min();
constexpr Vertex kMost = std::numeric_limits<Vertex>::max();

// Points 0, 2 and 3 are equal, and 1 and 4.
const std::vector<Point> kPoints = {{0, 0}, {1, 0}, {0, 0}, {0, 0}, {1, 0}, {0, 1}};

Mesh merged(std::vector<Rational> weights, std::vector<Simplex> simplices) {
  return mesh_of_merged(kPoints, std::move(weights), duplicates(kPoints), 10, std::move(simplices));
}

}  // namespace

static_assert(place_of_index(kLeast, kMost) == 1 && index_of_place(1, kMost) == kLeast);
static_assert(place_of_index(kMost, kLeast) == -1 && index_of_place(-1, kLeast) == kMost);
static_assert(has_room(kMost, 0) && has_room(kMost, 1) && !has_room(kMost, 2));
static_assert(has_room(kLeast, 0) && has_room(kLeast, std::size_t(-1)));
static_assert(has_room(-1, 3) && has_room(kMost - 2, 3) && !has_room(kMost - 2, 4));

TEST_CASE("of equal points the first is left, in the place and by the name of the first") {
  const Mesh mesh = merged({}, {{2, 4, 5}, {0, 1, 5}, {3, 7, -1}});
  CHECK(mesh.points.points() == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(mesh.labels == std::vector<Vertex>{10, 11, 15});
  CHECK(mesh.simplices == std::vector<Simplex>{{0, 1, 2}, {0, 1, 2}, {0, 7, -1}});
  CHECK(mesh.listed(mesh.simplices[0], 0) == Simplex{12, 14, 15});
  CHECK(mesh.listed(mesh.simplices[1], 1) == Simplex{10, 11, 15});
  CHECK(mesh.listed(mesh.simplices[2], 2) == Simplex{13, 17, 9});
  // Without its place, and in another order, as the first that was renamed.
  CHECK(mesh.listed({2, 0, 1}) == Simplex{15, 12, 14});
  CHECK(mesh.listed({0, 1}) == Simplex{10, 11});
}

TEST_CASE("of equal weighted points the heaviest is left, of several the first") {
  const Mesh mesh = merged({1, 5, 3, 3, 2, 0}, {{0, 1, 5}, {2, 4, 5}});
  CHECK(mesh.labels == std::vector<Vertex>{12, 11, 15});
  CHECK(mesh.points.weight(0) == 3);
  CHECK(mesh.points.weight(1) == 5);
  CHECK(mesh.listed(mesh.simplices[0], 0) == Simplex{10, 11, 15});
  CHECK(mesh.listed(mesh.simplices[1], 1) == Simplex{12, 14, 15});
}

TEST_CASE("what names no point names none when points are merged, and is named as it was") {
  for (const Vertex wrong : {Vertex{-1}, Vertex{6}, kMost, kLeast}) {
    const Mesh mesh = merged({}, {{2, wrong}});
    CHECK(!mesh.points.names(mesh.simplices[0][1]));
    CHECK(mesh.label(mesh.simplices[0][1]) == index_of_place(wrong, 10));
  }
}

}  // namespace circumspect
