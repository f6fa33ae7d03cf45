// The lists into which readers read: their values, and when they leave the narrow form.
#include <limits>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "oracle/formats/bytes/indices.hpp"
#include "oracle/formats/bytes/point_rows.hpp"
#include "oracle/formats/bytes/runs.hpp"
#include "oracle/formats/bytes/simplex_rows.hpp"

namespace circumspect::formats {

TEST_CASE("runs: any integers, in memory for each change alone") {
  Runs<Vertex> runs;
  const std::vector<Vertex> values = {5, 5, 5, 6, 7, 8, 8, 3, 9, 9, 10, 10, 10, -4, -3, -2, 0, 0};
  for (const Vertex value : values) runs.push_back(value);
  CHECK(runs == values);
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(runs[i] == values[i]);
  CHECK(runs.front() == 5);
  CHECK(runs.back() == 0);
  runs.clear();
  CHECK(runs.empty());
  runs.push_back(4);
  CHECK(runs == std::vector<Vertex>{4});
  const Runs<Vertex> extremes = {std::numeric_limits<Vertex>::max(),
                                 std::numeric_limits<Vertex>::min(), 0};
  CHECK(extremes == std::vector<Vertex>{std::numeric_limits<Vertex>::max(),
                                        std::numeric_limits<Vertex>::min(), 0});
  CHECK(rc::check("any", [](const std::vector<std::uint8_t>& some) {
    Runs<Vertex> any;
    std::vector<Vertex> expected;
    for (const std::uint8_t value : some) {
      expected.push_back(value % 4);
      any.push_back(value % 4);
    }
    RC_ASSERT(any == expected);
    for (std::size_t i = 0; i < expected.size(); ++i) RC_ASSERT(any[i] == expected[i]);
  }));
}

TEST_CASE("indices: of 32 bits until one does not fit, also where they are replaced") {
  Indices indices;
  for (const Vertex v : {1, -2, 2147483647}) indices.push_back(v);
  CHECK(indices.grow(1).size() == 1);
  indices.shrink_to(3);
  indices.replace_each([](Vertex v) { return v + 1; });  // the last one no longer fits
  CHECK(indices[0] == 2);
  CHECK(indices[1] == -1);
  CHECK(indices.back() == 2147483648);
  CHECK(indices.grow(1).empty());
  indices.push_back(7);
  CHECK(indices.size() == 4);
  CHECK(std::move(indices).as_rows(2).rows<std::int64_t>()->row(1)[1] == 7);
}

TEST_CASE("points: doubles, and exact numbers from the first that is not a double") {
  PointRows rows;
  rows.set_columns(2);
  rows.add(0.5);
  rows.add(Rational(-3));
  CHECK(std::holds_alternative<Rows<double>>(PointRows(rows).as_numbers(2)));
  rows.add(Rational(1, 3));
  rows.add(0.1);
  CHECK(rows.size() == 2);
  CHECK(rows[0] == Point{Rational(1, 2), -3});
  CHECK(rows[1] == Point{Rational(1, 3), exact_value(0.1)});
  CHECK(rows.in_order({1, 0})[0] == rows[1]);
  const Numbers exact = PointRows(rows).as_numbers(2);
  CHECK(std::get<Rows<Rational>>(exact).row(1)[0] == Rational(1, 3));
  // What is left of them may be doubles again.
  PointRows heights = {{1, Rational(1, 3)}, {2, Rational(1, 3)}};
  heights.drop_last_column();
  CHECK(heights == PointRows{{1}, {2}});
  CHECK(std::holds_alternative<Rows<double>>(std::move(heights).as_numbers(1)));
  CHECK(columns_of(PointRows().as_numbers(3)) == 3);
}

TEST_CASE("simplices: rows while all have one length, else lists") {
  SimplexRows rows = {{0, 1, 2}, {1, 2, 3}};
  CHECK(rows.columns() == 3);
  CHECK(SimplexRows(rows).as_index_lists().columns() == 3);
  rows.push_back({7, Vertex{1} << 40});
  CHECK(rows.columns() == 0);
  CHECK(rows.size_of(2) == 2);
  CHECK(rows == std::vector<Simplex>{{0, 1, 2}, {1, 2, 3}, {7, Vertex{1} << 40}});
  CHECK(SimplexRows(rows).as_index_lists()[2] == Simplex{7, Vertex{1} << 40});
  CHECK(SimplexRows().as_index_lists().empty());
}

}  // namespace circumspect::formats
