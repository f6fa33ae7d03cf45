// What is judged in arrays, which judge does it, and what is refused. Compared with the checkers:
// corpus/arrays_test.cpp, properties/arrays_property.cpp.
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include <circumspect/check.hpp>
#include <circumspect/judgement.hpp>
#include <doctest/doctest.h>

namespace circumspect {

namespace {

constexpr JudgeOptions kMerging{.merge_equal_points = true};

// A square and its centre.
const std::vector<double> kSquareWithCenter = {0, 0, 2, 0, 2, 2, 0, 2, 1, 1};
const std::vector<std::int32_t> kFanAboutCenter = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
const std::vector<std::int32_t> kNeighbors = {1, 3, -1, 2, 0, -1, 3, 1, -1, 0, 2, -1};

MeshArrays<std::int32_t> fan() {
  return {.dimension = 2,
          .coordinates = kSquareWithCenter,
          .simplices = kFanAboutCenter,
          .neighbors = kNeighbors};
}

TEST_CASE("what holds is decided fast, with its facts") {
  for (const unsigned threads : {0U, 1U, 2U}) {
    const MeshJudgement judgement = judge("delaunay", fan(), {.threads = threads});
    CHECK(judgement.holds);
    CHECK(judgement.unique == true);
    CHECK(judgement.canonical == true);
    CHECK(judgement.report.empty());
    CHECK(judgement.counts.fast);
    CHECK(judgement.counts.filtered_signs > 0);
  }
  CHECK(judge("weighted-delaunay", fan()).unique == true);
  const MeshJudgement triangulation = judge("triangulation", fan());
  CHECK(triangulation.holds);
  CHECK_FALSE(triangulation.unique.has_value());
  const std::vector<std::int64_t> wide(kFanAboutCenter.begin(), kFanAboutCenter.end());
  const MeshArrays<std::int64_t> mesh{2, kSquareWithCenter, {}, wide, {}};
  CHECK(judge("delaunay", mesh).counts.fast);
}

TEST_CASE("what does not hold comes with a witness, and is decided fast") {
  std::vector<std::int32_t> changed = kNeighbors;
  std::swap(changed[0], changed[1]);
  MeshArrays<std::int32_t> mesh = fan();
  mesh.neighbors = changed;
  const MeshJudgement judgement = judge("delaunay", mesh);
  CHECK_FALSE(judgement.holds);
  CHECK(judgement.rule == "complex.wrong-neighbor");
  CHECK(judgement.report.find("neighbour listed") != std::string::npos);
  CHECK(judgement.counts.fast);
  CHECK(judgement.counts.why_not_fast.empty());
  mesh.neighbors = {};
  CHECK(judge("delaunay", mesh).holds);
}

TEST_CASE("of what is wrong the fast judge tells which, and the slow one why") {
  const std::vector<double> kite = {-2, 0, 2, 0, 0, 1, 0, -0.5, 9, 9};
  const std::vector<std::int32_t> longer = {0, 1, 2, 3, 1, 0};
  const std::span<const double> points = std::span(kite).first(8);
  const MeshJudgement judgement = judge("delaunay", {2, points, {}, longer, {}});
  CHECK_FALSE(judgement.holds);
  CHECK(judgement.counts.fast);
  CHECK(judgement.counts.why_not_fast.empty());
  CHECK(judgement.rule == "delaunay.facet-not-local");
  CHECK(judgement.report ==
        judge("delaunay", {2, {points.begin(), points.end()}}, {{0, 1, 2}, {3, 1, 0}}).report);
  CHECK_FALSE(judgement.unique.has_value());
  CHECK(judge("triangulation", {2, points, {}, longer, {}}).holds);
  const std::vector<std::int64_t> wide(longer.begin(), longer.end());
  const MeshJudgement of_wide =
      judge("delaunay", MeshArrays<std::int64_t>{2, points, {}, wide, {}});
  CHECK(of_wide.counts.fast);
  CHECK(of_wide.report == judgement.report);
  const MeshJudgement unused = judge("delaunay", {2, kite, {}, longer, {}});
  CHECK(unused.counts.fast);
  CHECK(unused.rule == "triangulation.unused-point");
  // If no simplex is sound, the slow judge does everything.
  const std::vector<std::int32_t> flat = {0, 1, 1};
  const MeshJudgement unsound = judge("delaunay", {2, points, {}, flat, {}});
  CHECK_FALSE(unsound.counts.fast);
  CHECK(unsound.counts.why_not_fast == "a flat simplex");
  CHECK(unsound.rule == "simplex.repeated-vertex");
}

TEST_CASE(
    "other dimensions and equal points are for the slow judge, lattices of a few ulps are not") {
  const std::vector<double> line = {0, 3, 1};
  const std::vector<std::int32_t> edges = {0, 2, 2, 1};
  const MeshJudgement judgement = judge("delaunay", {1, line, {}, edges, {}});
  CHECK(judgement.holds);
  CHECK(judgement.unique == true);
  CHECK_FALSE(judgement.counts.fast);
  const std::vector<double> repeated = {0, 0, 1, 0, 0, 0, 0, 1};
  const std::vector<std::int32_t> triangle = {2, 1, 3};
  CHECK(judge("delaunay", {2, repeated, {}, triangle, {}}, kMerging).holds);
  const double ulp = std::numeric_limits<double>::epsilon();
  const std::vector<double> tiny = {1, 1, 1 + ulp, 1, 1, 1 + ulp};
  const std::vector<std::int32_t> one = {0, 1, 2};
  CHECK(judge("delaunay", {2, tiny, {}, one, {}}).counts.fast);
  CHECK(judge("delaunay", {2, tiny, {}, one, {}}).holds);
}

TEST_CASE("arrays whose lengths do not agree are refused, and numbers that are not finite") {
  const auto refused = [](auto change) {
    MeshArrays<std::int32_t> mesh = fan();
    change(mesh);
    CHECK_THROWS_AS(judge("delaunay", mesh), std::invalid_argument);
  };
  refused([](auto& mesh) { mesh.dimension = 0; });
  refused([](auto& mesh) { mesh.coordinates = mesh.coordinates.first(9); });
  refused([](auto& mesh) { mesh.simplices = mesh.simplices.first(11); });
  refused([](auto& mesh) { mesh.weights = mesh.coordinates.first(4); });
  refused([](auto& mesh) { mesh.neighbors = mesh.neighbors.first(9); });
  std::vector<double> infinite = kSquareWithCenter;
  infinite[3] = std::numeric_limits<double>::infinity();
  refused([&](auto& mesh) { mesh.coordinates = infinite; });
  CHECK_THROWS_AS(judge("cdt", fan()), std::invalid_argument);
}

// What is judged in memory, and what is refused.

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
  // Nor does it name one of the points that are left when equal ones are merged.
  const PointArray repeated{2, {0, 0, 0, 0, 1, 0, 0, 1}, {}};
  CHECK(judge("delaunay", repeated, {{0, 2, 3}}, kMerging).holds);
  CHECK(judge("delaunay", repeated, {{0, 2, 4}}, kMerging).rule == "triangulation.unknown-vertex");
}

TEST_CASE("equal points count as one, whichever of them is named, where they are to be merged") {
  const PointArray repeated{2, {0, 0, 1, 0, 0, 0, 0, 1, 1, 0}, {}};
  CHECK(judge("delaunay", repeated, {{0, 1, 3}}, kMerging).holds);
  CHECK(judge("delaunay", repeated, {{2, 4, 3}}, kMerging).holds);
  CHECK(judge("delaunay", repeated, {{0, 2, 3}}, kMerging).rule == "simplex.repeated-vertex");
}

TEST_CASE("equal points and empty meshes are refused otherwise") {
  // Two triangles that share no vertex, as made by a program that forgets to share them.
  const PointArray torn{2, {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 1}, {}};
  const std::vector<std::int32_t> seam = {0, 1, 2, 4, 5, 3};
  const std::string message = "expected distinct points, found points 0 and 4 equal and 1 more";
  CHECK_THROWS_WITH_AS(judge("delaunay", torn, {{0, 1, 2}, {4, 5, 3}}),
                       doctest::Contains(message.c_str()), std::invalid_argument);
  CHECK_THROWS_WITH_AS(judge("triangulation", {2, torn.coordinates, {}, seam, {}}),
                       doctest::Contains(message.c_str()), std::invalid_argument);
  CHECK(judge("delaunay", {2, torn.coordinates, {}, seam, {}}, kMerging).holds);
  for (const char* const claim : {"triangulation", "delaunay", "weighted-delaunay"}) {
    CHECK_THROWS_WITH_AS(judge(claim, {3, {}, {}}, SimplexArray{}),
                         doctest::Contains("neither points"), std::invalid_argument);
    CHECK_THROWS_WITH_AS(judge(claim, MeshArrays<std::int32_t>{}),
                         doctest::Contains("neither points"), std::invalid_argument);
    CHECK(judge(claim, MeshArrays<std::int32_t>{}, {.allow_empty = true}).holds);
  }
}

TEST_CASE("of equal weighted points the heaviest counts") {
  // Four points around the centre, which is there twice: light, then heavy enough to be a vertex.
  const PointArray points{2, {0, 0, 2, 0, 2, 2, 0, 2, 1, 1, 1, 1}, {0, 0, 0, 0, -3, 0}};
  const SimplexArray fan = {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 0, 5}};
  CHECK(judge("weighted-delaunay", points, fan, kMerging).holds);
  CHECK_FALSE(judge("weighted-delaunay", points, {{0, 1, 2}, {0, 2, 3}}, kMerging).holds);
}

TEST_CASE("an empty mesh of points does not hold, and a single point does") {
  CHECK_FALSE(judge("delaunay", kSquare, {}).holds);
  CHECK(judge("delaunay", {3, {1, 2, 3}, {}}, {{0}}).holds);
  CHECK(judge("delaunay", {3, {}, {}}, SimplexArray{}, {.allow_empty = true}).holds);
}

TEST_CASE("what is not an input is refused") {
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
