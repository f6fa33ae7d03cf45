// What is judged in memory, and what is refused.
#include <limits>
#include <stdexcept>

#include <circumspect/judgement.hpp>
#include <doctest/doctest.h>

namespace circumspect {
namespace {

// A square and its centre.
const PointArray kSquare{2, {0, 0, 2, 0, 2, 2, 0, 2, 1, 1}, {}};
const SimplexArray kFan = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

TEST_CASE("a Delaunay triangulation holds, in any order of rows and indices") {
  const Judgement judgement =
      judge("delaunay", kSquare, {{4, 3, 2}, {4, 0, 1}, {0, 4, 3}, {2, 1, 4}});
  CHECK(judgement.holds);
  CHECK(judgement.rule.empty());
  CHECK(judgement.report.empty());
  CHECK(judge("triangulation", kSquare, kFan).holds);
  CHECK(judge("weighted-delaunay", kSquare, kFan).holds);
}

TEST_CASE("what is wrong comes with its rule and a witness") {
  const PointArray kite{2, {0, 0, 4, -1, 8, 0, 4, 1}, {}};
  const SimplexArray long_edge = {{0, 1, 2}, {0, 2, 3}};
  CHECK(judge("triangulation", kite, long_edge).holds);
  const Judgement judgement = judge("delaunay", kite, long_edge);
  CHECK_FALSE(judgement.holds);
  CHECK(judgement.rule == "delaunay.facet-not-local");
  CHECK(judgement.report.find("circumball") != std::string::npos);
}

TEST_CASE("an index that names no point is the program's fault") {
  for (const std::int64_t wrong :
       {std::int64_t{5}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::max()}) {
    SimplexArray fan = kFan;
    fan[3][0] = wrong;
    CHECK(judge("delaunay", kSquare, fan).rule == "triangulation.unknown-vertex");
  }
  // Nor does it come to name one of the points that are left when equal ones are merged.
  const PointArray repeated{2, {0, 0, 0, 0, 1, 0, 0, 1}, {}};
  CHECK(judge("delaunay", repeated, {{0, 2, 3}}).holds);
  CHECK(judge("delaunay", repeated, {{0, 2, 4}}).rule == "triangulation.unknown-vertex");
}

TEST_CASE("equal points count as one, whichever of them is named") {
  const PointArray repeated{2, {0, 0, 1, 0, 0, 0, 0, 1, 1, 0}, {}};
  CHECK(judge("delaunay", repeated, {{0, 1, 3}}).holds);
  CHECK(judge("delaunay", repeated, {{2, 4, 3}}).holds);
  CHECK(judge("delaunay", repeated, {{0, 2, 3}}).rule == "simplex.repeated-vertex");
}

TEST_CASE("of equal weighted points the heaviest counts") {
  // Four points around the centre, which is there twice: light, then heavy enough to be a vertex.
  const PointArray points{2, {0, 0, 2, 0, 2, 2, 0, 2, 1, 1, 1, 1}, {0, 0, 0, 0, -3, 0}};
  CHECK(judge("weighted-delaunay", points, {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 0, 5}}).holds);
  CHECK_FALSE(judge("weighted-delaunay", points, {{0, 1, 2}, {0, 2, 3}}).holds);
}

TEST_CASE("an empty mesh of points does not hold, and a single point does") {
  CHECK_FALSE(judge("delaunay", kSquare, {}).holds);
  CHECK(judge("delaunay", {3, {1, 2, 3}, {}}, {{0}}).holds);
  CHECK(judge("delaunay", {3, {}, {}}, SimplexArray{}).holds);
}

TEST_CASE("what is no input is refused") {
  CHECK_THROWS_AS(judge("cdt", kSquare, kFan), std::invalid_argument);
  CHECK_THROWS_AS(judge("", kSquare, kFan), std::invalid_argument);
  CHECK_THROWS_AS(judge("delaunay", {2, {0, 0, 1}, {}}, {}), std::invalid_argument);
  CHECK_THROWS_AS(judge("delaunay", {0, {0}, {}}, {}), std::invalid_argument);
  CHECK_THROWS_AS(judge("delaunay", {2, {0, 0}, {1, 2}}, {}), std::invalid_argument);
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(judge("delaunay", {1, {infinity}, {}}, {}), std::invalid_argument);
  CHECK_THROWS_AS(judge("weighted-delaunay", {1, {0}, {infinity}}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace circumspect
