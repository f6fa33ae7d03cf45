// What the C interface refuses unless an option allows it, and what ends its calls.
#include <atomic>
#include <chrono>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

// A square of two triangles that share no vertex, as made by a mesher that forgets to share them.
const std::vector<double> kTorn = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 1};
const std::vector<std::int32_t> kSeam = {0, 1, 2, 4, 5, 3};

TEST_CASE("equal points are refused, or merged with a note") {
  const circumspect_mesh torn = mesh_of(kTorn, kSeam);
  const circumspect_domain domain = square();
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  for (const char* const within : {static_cast<const char*>(nullptr), "1e-9"}) {
    const circumspect_domain* const about = within == nullptr ? nullptr : &domain;
    const char* const claim = within == nullptr ? "delaunay" : "cdt";
    options = CIRCUMSPECT_OPTIONS;
    options.within = within;
    CHECK(check(claim, &torn, about, &options).status == CIRCUMSPECT_INPUT_FAULT);
    CHECK(has(circumspect_last_error(),
              "expected distinct points, found points 0 and 4 equal and 1 more duplicate"));
    CHECK(has(circumspect_last_error(), "set merge_equal_points"));
    CHECK(std::string(circumspect_last_option()) == "merge_equal_points");
    CHECK(std::string(circumspect_last_fault()) ==
          "expected distinct points, found points 0 and 4 equal and 1 more duplicate");
    options.merge_equal_points = 1;
    const Checked merged = check(claim, &torn, about, &options);
    CHECK(circumspect_verdict_holds(merged.verdict.get()) == 1);
    REQUIRE(circumspect_verdict_note_count(merged.verdict.get()) == 1);
    const std::string note = circumspect_verdict_note(merged.verdict.get(), 0);
    CHECK(note ==
          "points 0 and 4 are equal and count as one; in all, 2 points repeat an earlier one");
    CHECK(has(circumspect_verdict_json(merged.verdict.get()), note));
    CHECK(circumspect_verdict_note(merged.verdict.get(), 1) == nullptr);
    CHECK(circumspect_verdict_note(merged.verdict.get(), -1) == nullptr);
  }
  CHECK(check("cdt", &torn, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  const circumspect_mesh whole = mesh_of(kPoints, kRight);
  CHECK(circumspect_verdict_note_count(check("delaunay", &whole).verdict.get()) == 0);
  CHECK(circumspect_verdict_note_count(nullptr) == 0);
  int answer = 0;
  circumspect_document* document = nullptr;
  CHECK(circumspect_compare(&torn, &whole, &answer, &document) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(circumspect_certify("delaunay", &torn, &answer, &document) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "found points 0 and 4 equal"));
  CHECK(std::string(circumspect_last_option()).empty());
  CHECK(has(circumspect_last_fault(), "found points 0 and 4 equal"));
}

TEST_CASE("of equal weighted points the heaviest counts, where they are merged") {
  const std::vector<double> points = {0, 0, 2, 0, 2, 2, 0, 2, 1, 1, 1, 1};
  const std::vector<double> weights = {0, 0, 0, 0, -3, 0};
  circumspect_mesh mesh = mesh_of(points, {});
  const std::vector<std::int32_t> fan = {0, 1, 5, 1, 2, 5, 2, 3, 5, 3, 0, 5};
  mesh.simplex_count = 4;
  mesh.simplices = fan.data();
  mesh.weights = weights.data();
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.merge_equal_points = 1;
  CHECK(circumspect_verdict_holds(
            check("weighted-delaunay", &mesh, nullptr, &options).verdict.get()) == 1);
}

TEST_CASE("a mesh of nothing is refused, unless it is allowed") {
  circumspect_mesh nothing = CIRCUMSPECT_MESH;
  nothing.dimension = 3;
  const circumspect_domain domain = tetrahedron();
  CHECK(check("delaunay", &nothing).status == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "found neither points nor simplices"));
  CHECK(has(circumspect_last_error(), "; to judge an empty mesh, set allow_empty"));
  CHECK(std::string(circumspect_last_option()) == "allow_empty");
  CHECK(check("cdt", &nothing, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.allow_empty = 1;
  CHECK(circumspect_verdict_holds(check("delaunay", &nothing, nullptr, &options).verdict.get()) ==
        1);
  CHECK(circumspect_verdict_holds(check("cdt", &nothing, &domain, &options).verdict.get()) == 0);
  int answer = 0;
  circumspect_document* document = nullptr;
  CHECK(circumspect_compare(&nothing, &nothing, &answer, &document) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(circumspect_certify("delaunay", &nothing, &answer, &document) == CIRCUMSPECT_INPUT_FAULT);
  // Points without simplices are a mesh, and a wrong one.
  const circumspect_mesh points = mesh_of(kPoints, {});
  CHECK(circumspect_verdict_holds(check("delaunay", &points).verdict.get()) == 0);
  // So are simplices, triangles or edges without points.
  circumspect_mesh without_points = mesh_of({}, kRight);
  CHECK(circumspect_verdict_holds(check("complex", &without_points).verdict.get()) == 0);
  const std::vector<std::int64_t> edge = {0, 1};
  without_points.simplex_count = 0;
  without_points.edge_count = 1;
  without_points.edges = edge.data();
  CHECK(circumspect_verdict_holds(check("cdt", &without_points, &domain).verdict.get()) == 0);
}

TEST_CASE(
    "options of an earlier version mean what they meant, and refuse what is refused by default") {
  const circumspect_mesh torn = mesh_of(kTorn, kSeam);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.struct_size = offsetof(circumspect_options, merge_equal_points);
  options.merge_equal_points = 1;  // is beyond its end
  CHECK(check("delaunay", &torn, nullptr, &options).status == CIRCUMSPECT_INPUT_FAULT);
  const circumspect_mesh mesh = mesh_of(kPoints, kRight);
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_OK);
}

TEST_CASE("what is quoted in an error stays on one line, and no character is cut in two") {
  const std::string text = std::string("1\n\x1b[31m\xff");
  const char* const texts[] = {"0", "0", text.c_str(), "0", "0", "1"};
  circumspect_mesh mesh = mesh_of(kPoints, kRight);
  mesh.coordinates = nullptr;
  mesh.exact_coordinates = texts;
  mesh.point_count = 3;
  CHECK(check("delaunay", &mesh).status == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "found 1\\x0a\\x1b[31m\\xff in the coordinates at place 2"));
  std::string claim;
  for (int i = 0; i < 3000; ++i) claim += "é";
  for (const std::string& odd : {claim, "a" + claim}) {
    CHECK(check(odd.c_str(), &mesh).status == CIRCUMSPECT_INVALID_ARGUMENT);
    const std::string error = circumspect_last_error();
    CHECK(error.size() >= 1990);
    CHECK(error.ends_with("é"));
  }
}

TEST_CASE("starts that no array can have are refused") {
  const std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const std::vector<std::int64_t> starts = {0, 1, 2, 3, most};
  const std::vector<std::int64_t> lines = {0, 3, 6, 9, most};
  circumspect_triangulation* built = nullptr;
  circumspect_domain domain = tetrahedron();
  domain.polygon_starts = starts.data();
  CHECK(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "expected fewer line_starts"));
  domain = tetrahedron();
  domain.line_starts = lines.data();
  CHECK(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "expected fewer corners"));
  // The first line, or the first corner, would be left out.
  const std::vector<std::int64_t> later = {1, 1, 2, 3, 4}, later_corners = {1, 3, 6, 9, 12};
  check_refused(of_polygons(kTetrahedron, later, kLineStarts, kFaces), CIRCUMSPECT_INVALID_ARGUMENT,
                "expected polygon_starts that ascend from 0");
  check_refused(of_polygons(kTetrahedron, kStarts, later_corners, kFaces),
                CIRCUMSPECT_INVALID_ARGUMENT, "expected line_starts that ascend from 0");
  const std::vector<std::int64_t> empty_line = {0, 0, 6, 9, 12};
  check_refused(of_polygons(kTetrahedron, kStarts, empty_line, kFaces),
                CIRCUMSPECT_INVALID_ARGUMENT, "expected lines with corners");
  domain = tetrahedron();
  domain.polygon_count = most;
  CHECK(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "expected fewer polygon_starts"));
}

// A mesh that takes minutes by definition: a fan over points in convex position, on a curve like a
// parabola.
struct LongWork {
  LongWork() {
    constexpr std::int32_t kPointsOfFan = 2000;
    for (std::int32_t i = 0; i < kPointsOfFan; ++i) {
      points.insert(points.end(), {static_cast<double>(i), static_cast<double>(i) * i});
      if (i >= 2) rows.insert(rows.end(), {0, i - 1, i});
    }
    options.by_definition = 1;
  }
  circumspect_status judged() const {
    const circumspect_mesh mesh = mesh_of(points, rows);
    circumspect_verdict* verdict = nullptr;
    const circumspect_status status =
        circumspect_check("triangulation", &mesh, nullptr, &options, &verdict);
    circumspect_verdict_free(verdict);
    return status;
  }

  std::vector<double> points = {};
  std::vector<std::int32_t> rows = {};
  circumspect_options options = CIRCUMSPECT_OPTIONS;
};

TEST_CASE("a limit or another thread ends a long call") {
  using Clock = std::chrono::steady_clock;
  const LongWork work;
  const Clock::time_point begin = Clock::now();
  circumspect_end_calls_after(0.05, nullptr);
  CHECK(work.judged() == CIRCUMSPECT_UNDECIDED);
  CHECK(has(circumspect_last_error(), "within the time limit"));
  // A call that takes no time is not late, and neither are the calls after it.
  const circumspect_mesh mesh = mesh_of(kPoints, kRight);
  CHECK(check("delaunay", &mesh).status == CIRCUMSPECT_OK);
  std::int32_t stop = 0;
  circumspect_end_calls_after(0, &stop);
  std::jthread other([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    __atomic_store_n(&stop, 1, __ATOMIC_RELAXED);
  });
  CHECK(work.judged() == CIRCUMSPECT_UNDECIDED);
  CHECK(has(circumspect_last_error(), "that the call was stopped"));
  circumspect_end_calls_after(std::numeric_limits<double>::quiet_NaN(), nullptr);
  CHECK(check("delaunay", &mesh).status == CIRCUMSPECT_OK);
  circumspect_end_calls_after(0, nullptr);
  CHECK(Clock::now() - begin < std::chrono::seconds(20));
}

TEST_CASE("what ends a call of one thread ends no call of another") {
  std::int32_t stop = 1;
  circumspect_end_calls_after(0, &stop);
  const circumspect_mesh mesh = mesh_of(kPoints, kWrong);
  CHECK(check("delaunay", &mesh).status == CIRCUMSPECT_UNDECIDED);
  std::jthread([&mesh] { CHECK(check("delaunay", &mesh).status == CIRCUMSPECT_OK); }).join();
  circumspect_end_calls_after(0, nullptr);
}

}  // namespace
}  // namespace circumspect::c
