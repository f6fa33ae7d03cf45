// Meshes in arrays, and equal points of them.
#include "oracle/model/mesh.hpp"

#include <limits>

#include <doctest/doctest.h>

namespace circumspect {

// ---- Mesh ----
// A mesh in arrays uses the narrowest that hold it, and is the same mesh as the exact one.

namespace {

constexpr Vertex kWide = Vertex{1} << 40;

// The result of in_rows, and that of exact() on it.
ExactMesh there_and_back(const ExactMesh& mesh) { return exact(in_rows(mesh)); }

bool are_doubles(const Numbers& numbers) { return std::holds_alternative<Rows<double>>(numbers); }

}  // namespace

TEST_CASE("numbers are doubles where all of them are") {
  const Rational third = Rational(1) / 3;
  CHECK(are_doubles(numbers_of({{0, Rational(1) / 1024}, {-7, 9}}, 2)));
  CHECK(!are_doubles(numbers_of({{0, 1}, {third, 9}}, 2)));
  CHECK(are_doubles(numbers_of({}, 3)));
  CHECK(columns_of(numbers_of({}, 3)) == 3);
  CHECK(!are_doubles(numbers_of(std::vector<Rational>{1, third})));
  // Larger than any double, and smaller than the least positive one.
  Rational huge = 2;
  for (int i = 0; i < 11; ++i) huge *= huge;
  CHECK(!are_doubles(numbers_of(std::vector<Rational>{huge})));
  CHECK(!are_doubles(numbers_of(std::vector<Rational>{1 / huge})));
  CHECK(rows_of(numbers_of(std::vector<Rational>{huge, 1})) == 2);
}

TEST_CASE("indices are in the narrowest rows, or in lists where these differ") {
  const IndexLists narrow(std::vector<Simplex>{{0, 1, -1}, {2, 3, 4}});
  REQUIRE(narrow.rows<std::int32_t>());
  CHECK(narrow.columns() == 3);
  CHECK(narrow[1] == Simplex{2, 3, 4});
  const IndexLists wide(std::vector<Simplex>{{0, kWide}});
  REQUIRE(wide.rows<std::int64_t>());
  CHECK(wide[0] == Simplex{0, kWide});
  for (const std::vector<Simplex>& lists : {std::vector<Simplex>{{0, 1}, {2}}, {{}, {}}, {}}) {
    const IndexLists uneven(lists);
    CHECK(uneven.columns() == 0);
    CHECK(uneven.size() == lists.size());
    CHECK(uneven.lists() == lists);
  }
}

TEST_CASE("rows that lie elsewhere are not copied") {
  const std::vector<double> square = {0, 0, 1, 0, 0, 1, 1, 1};
  Mesh mesh;
  mesh.coordinates = Rows<double>::of(square, 2);
  CHECK(mesh.points() == 4);
  CHECK(mesh.dimension() == 2);
  CHECK(mesh.point(3) == Point{1, 1});
  const Numbers& numbers = mesh.coordinates;
  CHECK(std::get<Rows<double>>(numbers).values().data() == square.data());
  const Mesh moved = std::move(mesh);
  CHECK(moved.points() == 4);
}

TEST_CASE("exact numbers and lists come back from arrays, with labels and faces") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {Rational(1) / 3, 1}}, {0, 5, 2}),
                       {{0, 1, 2}, {0, 9}},
                       {4, 6, 8},
                       4,
                       {},
                       {{0, 1}}};
  const ExactMesh back = there_and_back(mesh);
  CHECK(back.points.points() == mesh.points.points());
  CHECK(back.points.weight(1) == 5);
  CHECK(back.simplices == mesh.simplices);
  CHECK(back.labels == mesh.labels);
  CHECK(back.first_index == 4);
  CHECK(back.faces == mesh.faces);
  CHECK(!back.neighbors);
  CHECK(in_rows(mesh).label(2) == 8);
  CHECK(in_rows(mesh).label(9) == 13);
}

TEST_CASE("neighbours are counted from 0, unless that makes one of them none") {
  ExactMesh mesh{PointSet({{0}, {1}, {2}}), {{0, 1}, {1, 2}}};
  for (const Vertex listed : {Vertex{1}, Vertex{2}, Vertex{-1}, Vertex{0}, Vertex{-5}, kWide,
                              std::numeric_limits<Vertex>::min()}) {
    CAPTURE(listed);
    mesh.neighbors = Neighbors{{{2, -1}, {-1, listed}}, 1};
    const Mesh rows = in_rows(mesh);
    CHECK(rows.neighbors->are_as_listed == (listed == 0));
    CHECK(rows.neighbors->rows[0] == (listed == 0 ? Simplex{2, -1} : Simplex{1, -1}));
    CHECK(there_and_back(mesh).neighbors->rows == mesh.neighbors->rows);
    CHECK(there_and_back(mesh).neighbors->first_index == 1);
  }
}

// ---- Equal points ----
// The points left by merging and their user indices; indices at the ends of 64 bits.

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

TEST_CASE("what names no point names none when points are merged, and is named as it was") {
  for (const Vertex wrong : {Vertex{-1}, Vertex{6}, kMost, kLeast}) {
    const Mesh mesh = merged({}, {{2, wrong}});
    CHECK(!mesh.names(mesh.simplices[0][1]));
    CHECK(mesh.label(mesh.simplices[0][1]) == index_of_place(wrong, 10));
  }
}

}  // namespace circumspect
