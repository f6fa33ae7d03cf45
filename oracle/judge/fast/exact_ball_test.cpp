// Several queries of one simplex are answered as one by one, by the same stages.
#include "oracle/judge/fast/exact_ball.hpp"

#include <doctest/doctest.h>

#include "oracle/judge/fast/exact_sign.hpp"
#include "oracle/judge/fast/tuples_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {
namespace {

template <std::size_t kDimension>
void hold_queries(Tuples& tuples, Kind kind, Stages& all) {
  constexpr std::size_t kQueries = 4;
  const auto sites = tuples.draw<kDimension, kDimension + 1 + kQueries>(kind);
  SiteRow<kDimension> row;
  for (std::size_t i = 0; i <= kDimension; ++i) row[i] = sites[i];
  ExactBall<kDimension> ball(row);
  for (std::size_t i = 0; i < kQueries; ++i) {
    CAPTURE(i);
    const Site<kDimension>& query = sites[kDimension + 1 + i];
    Stages one_by_one, together;
    const int expected = exact_ball_sign(row, query, false, one_by_one);
    REQUIRE(ball.contains(query, together) == expected);
    REQUIRE(together == one_by_one);
    all += together;
  }
}

TEST_CASE("queries of one simplex have the signs of exact_sign, by the same stages") {
  Stages all;
  for (int kind = 0; kind <= static_cast<int>(Kind::kLast); ++kind) {
    CAPTURE(kind);
    Tuples tuples(static_cast<std::uint64_t>(kind) + 7);
    for (int i = 0; i < 1000 / properties::kOneInputIn; ++i) {
      CAPTURE(i);
      hold_queries<2>(tuples, static_cast<Kind>(kind), all);
      hold_queries<3>(tuples, static_cast<Kind>(kind), all);
    }
  }
  CHECK(all.narrow > 0);
  CHECK(all.fixed > 0);
  CHECK(all.wide > 0);
  CHECK(all.unbounded > 0);
}

TEST_CASE("a query that is finer than the simplex is not cut off") {
  const SiteRow<3> row = {{{{0, 0, 0}}, {{0, 8, 0}}, {{8, 0, 0}}, {{0, 0, 8}}}};
  ExactBall<3> ball(row);
  Stages stages;
  const int inside = ball.contains({{1, 1, 1}}, stages);
  for (const double off : {1.0, 0x1p-9, 0x1p-20, 0x1p-45}) {
    CHECK(ball.contains({{8, 8, 8 + off}}, stages) == -inside);
    CHECK(ball.contains({{8, 8, 8 - off}}, stages) == inside);
    CHECK(ball.contains({{8, 8, 8}}, stages) == 0);
  }
}

}  // namespace
}  // namespace circumspect::fast
