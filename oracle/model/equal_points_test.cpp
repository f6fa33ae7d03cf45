// The points left by merging and their user indices; indices at the ends of 64 bits.
#include <limits>

#include <doctest/doctest.h>

#include "oracle/model/mesh.hpp"

namespace circumspect {
namespace {

constexpr Vertex kLeast = std::numeric_limits<Vertex>::min();
constexpr Vertex kMost = std::numeric_limits<Vertex>::max();

// Points 0, 2 and 3 are equal, and 1 and 4.
const std::vector<Point> kPoints = {{0, 0}, {1, 0}, {0, 0}, {0, 0}, {1, 0}, {0, 1}};

Mesh merged(const std::vector<Rational>& weights, std::vector<Simplex> simplices,
            const std::vector<Point>& points = kPoints) {
  Mesh mesh;
  mesh.coordinates = numbers_of(points, 2);
  if (!weights.empty()) mesh.weights = numbers_of(weights);
  mesh.simplices = IndexLists(std::move(simplices));
  mesh.first_index = 10;
  merge_equal_points(mesh);
  return mesh;
}

}  // namespace

static_assert(place_of_index(kLeast, kMost) == 1 && index_of_place(1, kMost) == kLeast);
static_assert(place_of_index(kMost, kLeast) == -1 && index_of_place(-1, kLeast) == kMost);
static_assert(has_room(kMost, 0) && has_room(kMost, 1) && !has_room(kMost, 2));
static_assert(has_room(kLeast, 0) && has_room(kLeast, std::size_t(-1)));
static_assert(has_room(-1, 3) && has_room(kMost - 2, 3) && !has_room(kMost - 2, 4));

TEST_CASE("of equal points the first is left, in the place and by the name of the first") {
  const Mesh mesh = merged({}, {{2, 4, 5}, {0, 1, 5}, {3, 7, -1}});
  CHECK(mesh.exact_points() == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(mesh.labels == std::vector<Vertex>{10, 11, 15});
  CHECK(mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2}, {0, 1, 2}, {0, 7, -1}});
  CHECK(mesh.listed(mesh.simplices[0], 0) == Simplex{12, 14, 15});
  CHECK(mesh.listed(mesh.simplices[1], 1) == Simplex{10, 11, 15});
  CHECK(mesh.listed(mesh.simplices[2], 2) == Simplex{13, 17, 9});
  // Found without its place, and in another order, as the first that was renamed.
  CHECK(mesh.listed({2, 0, 1}) == Simplex{15, 12, 14});
  CHECK(mesh.listed({0, 1}) == Simplex{10, 11});
}

TEST_CASE(
    "exact numbers are merged as doubles are, and equal points are found in the order of the "
    "later") {
  std::vector<Point> thirds = kPoints;
  for (Point& point : thirds) point[1] += Rational(1, 3);
  const Mesh mesh = merged({}, {{2, 4, 5}}, thirds);
  CHECK(std::holds_alternative<Rows<Rational>>(mesh.coordinates));
  CHECK(mesh.labels == std::vector<Vertex>{10, 11, 15});
  CHECK(mesh.point(2) == Point{0, Rational(4, 3)});
  CHECK(mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2}});
  CHECK(mesh.listed(mesh.simplices[0], 0) == Simplex{12, 14, 15});
  CHECK(equal_points(mesh).empty());
  for (const std::vector<Point>& points : {kPoints, thirds}) {
    Mesh again;
    again.coordinates = numbers_of(points, 2);
    const std::vector<Duplicate> found = equal_points(again);
    const std::vector<Duplicate> expected = duplicates(points);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].kept == expected[i].kept);
      CHECK(found[i].again == expected[i].again);
    }
  }
}

TEST_CASE("of equal weighted points the heaviest is left, of several the first") {
  const Mesh mesh = merged({1, 5, 3, 3, 2, 0}, {{0, 1, 5}, {2, 4, 5}});
  CHECK(mesh.labels == std::vector<Vertex>{12, 11, 15});
  CHECK(mesh.weight(0) == 3);
  CHECK(mesh.weight(1) == 5);
  CHECK(mesh.listed(mesh.simplices[0], 0) == Simplex{10, 11, 15});
  CHECK(mesh.listed(mesh.simplices[1], 1) == Simplex{12, 14, 15});
}

TEST_CASE("points that have indices of their own keep them, and are named by them") {
  Mesh mesh;
  mesh.coordinates = numbers_of(kPoints, 2);
  mesh.simplices = IndexLists(std::vector<Simplex>{{2, 4, 5}, {0, 7, -1}});
  mesh.first_index = 10;
  mesh.labels = {10, 20, 30, 40, 50, 60};  // others were left out
  const std::vector<Duplicate> repeated = merge_equal_points(mesh);
  CHECK(mesh.labels == std::vector<Vertex>{10, 20, 60});
  CHECK(mesh.listed(mesh.simplices[0], 0) == Simplex{30, 50, 60});
  CHECK(mesh.listed(mesh.simplices[1]) == Simplex{10, 17, 9});
  REQUIRE(repeated.size() == 3);
  CHECK(index_of_place(repeated.front().kept, 10) == 10);
  CHECK(index_of_place(repeated.front().again, 10) == 30);
}

TEST_CASE("what names no point names none when points are merged, and is named as it was") {
  for (const Vertex wrong : {Vertex{-1}, Vertex{6}, kMost, kLeast}) {
    const Mesh mesh = merged({}, {{2, wrong}});
    CHECK(!mesh.names(mesh.simplices[0][1]));
    CHECK(mesh.label(mesh.simplices[0][1]) == index_of_place(wrong, 10));
  }
}

}  // namespace circumspect
