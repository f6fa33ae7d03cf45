// A mesh in arrays uses the narrowest that hold it, and is the same mesh as the exact one.
#include "oracle/model/mesh.hpp"

#include <limits>

#include <doctest/doctest.h>

namespace circumspect {
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

}  // namespace circumspect
