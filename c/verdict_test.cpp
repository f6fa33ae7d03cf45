// What the C interface says about meshes.
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

TEST_CASE("a mesh that holds, and its facts") {
  const circumspect_mesh mesh = mesh_of(kPoints, kRight);
  const Checked found = check("delaunay", &mesh);
  REQUIRE(found.status == CIRCUMSPECT_OK);
  CHECK(circumspect_verdict_holds(found.verdict.get()) == 1);
  CHECK(circumspect_verdict_unique(found.verdict.get()) == 1);
  CHECK(circumspect_verdict_canonical(found.verdict.get()) == 1);
  CHECK(circumspect_verdict_rule_count(found.verdict.get()) == 0);
  CHECK(circumspect_verdict_violation_count(found.verdict.get()) == 0);
  CHECK(std::string(circumspect_verdict_text(found.verdict.get())) ==
        "holds: delaunay mesh 4 points 2 triangles unique canonical\n");
  CHECK(has(circumspect_verdict_json(found.verdict.get()), "\"verdict\": \"holds\""));
  CHECK(circumspect_verdict_unique(check("triangulation", &mesh).verdict.get()) == -1);
}

TEST_CASE("where no claim is named, the points decide which one is judged") {
  const auto judged = [](const std::vector<double>& points, const std::vector<std::int32_t>& rows,
                         const circumspect_domain* domain, const circumspect_options* options) {
    const circumspect_mesh mesh = mesh_of(points, rows);
    const Checked found = check(nullptr, &mesh, domain, options);
    REQUIRE(found.status == CIRCUMSPECT_OK);
    const std::string claim = circumspect_verdict_claim(found.verdict.get());
    CHECK(has(circumspect_verdict_text(found.verdict.get()), ": " + claim + " mesh "));
    return claim;
  };
  const std::vector<std::int32_t> halves = {0, 1, 2, 0, 2, 3};
  const circumspect_domain domain = square();
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  CHECK(judged(kPoints, kWrong, nullptr, nullptr) == "delaunay");
  CHECK(judged(kCorners, halves, &domain, nullptr) == "cdt");
  CHECK(judged({1, 0, 0, 0, 0, 1, 1, 1}, halves, &domain, nullptr) == "cdt");
  const std::vector<double> centre = {0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5};
  const std::vector<std::int32_t> fan = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  CHECK(judged(centre, fan, &domain, nullptr) == "steiner-cdt");
  // As many points, but other ones. With `within`, they may have been moved.
  const std::vector<double> moved = {0, 0, 1, 0, 1, 1, 0, 1.0625};
  CHECK(judged(moved, halves, &domain, nullptr) == "steiner-cdt");
  options.within = "0.125";
  CHECK(judged(moved, halves, &domain, &options) == "cdt");
  // Equal points are settled before the points are counted.
  const std::vector<double> torn = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 1};
  const std::vector<std::int32_t> seam = {0, 1, 2, 4, 5, 3};
  const circumspect_mesh split = mesh_of(torn, seam);
  CHECK(check(nullptr, &split, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  options = CIRCUMSPECT_OPTIONS;
  options.merge_equal_points = 1;
  CHECK(judged(torn, seam, &domain, &options) == "cdt");
  CHECK(std::string(circumspect_verdict_claim(nullptr)).empty());
}

TEST_CASE("a mesh alone: equal points break a rule, unless they are merged") {
  const std::vector<double> points = {0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 4, 4};
  const std::vector<std::int32_t> apart = {0, 1, 2, 3, 5, 4};
  const circumspect_mesh mesh = mesh_of(points, apart);
  const Checked found = check("complex", &mesh);
  REQUIRE(found.status == CIRCUMSPECT_OK);
  std::int64_t count = 0;
  REQUIRE(circumspect_verdict_rule_count(found.verdict.get()) == 1);
  CHECK(std::string(circumspect_verdict_rule(found.verdict.get(), 0, &count)) ==
        "complex.points-equal");
  CHECK(count == 2);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.merge_equal_points = 1;
  options.oriented = 1;
  const Checked merged = check("complex", &mesh, nullptr, &options);
  REQUIRE(merged.status == CIRCUMSPECT_OK);
  CHECK(has(circumspect_verdict_text(merged.verdict.get()), "1 part 4 boundary-facets positive"));
  const circumspect_mesh none = mesh_of(points, {});
  CHECK(check("complex", &none).status == CIRCUMSPECT_INPUT_FAULT);
}

TEST_CASE("a mesh that fails, and its witness in numbers") {
  circumspect_mesh mesh = mesh_of(kPoints, kWrong);
  const Checked found = check("delaunay", &mesh);
  REQUIRE(found.status == CIRCUMSPECT_OK);
  const circumspect_verdict* const verdict = found.verdict.get();
  CHECK(circumspect_verdict_holds(verdict) == 0);
  std::int64_t count = 0;
  REQUIRE(circumspect_verdict_rule_count(verdict) == 1);
  CHECK(std::string(circumspect_verdict_rule(verdict, 0, &count)) == "delaunay.facet-not-local");
  CHECK(count == 1);
  CHECK(circumspect_verdict_rule(verdict, 1, &count) == nullptr);
  CHECK(count == 0);
  CHECK(circumspect_verdict_rule(verdict, -1, nullptr) == nullptr);
  REQUIRE(circumspect_verdict_violation_count(verdict) == 1);
  circumspect_violation violation;
  REQUIRE(circumspect_verdict_violation(verdict, 0, &violation, sizeof violation) ==
          CIRCUMSPECT_OK);
  CHECK(std::string(violation.rule) == "delaunay.facet-not-local");
  CHECK(has(violation.meaning, "not locally Delaunay"));
  REQUIRE(violation.simplex_count >= 1);
  CHECK(violation.simplex_starts[1] == 3);
  CHECK(violation.simplices[0] == 0);
  REQUIRE(violation.face_size == 2);
  CHECK(violation.face[0] + violation.face[1] == 3);
  REQUIRE(violation.vertex_count == 1);
  CHECK(violation.vertices[0] == 3);
  REQUIRE(violation.centre_size == 2);
  CHECK(std::string(violation.centre[0].exact) == "1/2");
  CHECK(violation.centre[1].nearest == 0.5);
  CHECK(std::string(violation.squared_radius->exact) == "1/2");
  REQUIRE(violation.value_count >= 1);
  // The depth of the double 0.9 in the ball: a fraction that is not a double.
  CHECK(has(violation.values[0].exact, "/"));
  CHECK(std::isfinite(violation.values[0].nearest));
  CHECK(circumspect_verdict_violation(verdict, 1, &violation, sizeof violation) ==
        CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(violation.rule == nullptr);
  CHECK(has(circumspect_last_error(), "expected the index of one of 1 violation, found 1"));
  CHECK(circumspect_verdict_violation(verdict, 0, &violation, 8) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_verdict_violation(verdict, 0, nullptr, 0) == CIRCUMSPECT_INVALID_ARGUMENT);
  // An index that names no point is the mesh's fault, not the call's.
  const std::vector<std::int32_t> unknown = {0, 1, 4, -7, 3, 2};
  mesh.simplices = unknown.data();
  const Checked of_unknown = check("delaunay", &mesh);
  REQUIRE(of_unknown.status == CIRCUMSPECT_OK);
  CHECK(std::string(circumspect_verdict_rule(of_unknown.verdict.get(), 0, nullptr)) ==
        "triangulation.unknown-vertex");
}

TEST_CASE("as many witnesses are kept as was asked, and all are counted") {
  const std::vector<std::int32_t> unknown = {0, 1, 7, 0, 3, 8, 1, 2, 9};
  const circumspect_mesh mesh = mesh_of(kPoints, unknown);
  for (const std::int64_t most : {1, 2, 0}) {
    circumspect_options options = CIRCUMSPECT_OPTIONS;
    options.max_violations = most;
    const Checked found = check("triangulation", &mesh, nullptr, &options);
    REQUIRE(found.status == CIRCUMSPECT_OK);
    CHECK(circumspect_verdict_violation_count(found.verdict.get()) == (most == 0 ? 3 : most));
    std::int64_t count = 0;
    CHECK(has(circumspect_verdict_rule(found.verdict.get(), 0, &count), "unknown-vertex"));
    CHECK(count == 3);
  }
}

TEST_CASE("wide indices, neighbours, weights, exact numbers and options") {
  circumspect_mesh mesh = mesh_of(kPoints, kRight);
  const std::vector<std::int64_t> wide(kRight.begin(), kRight.end());
  const std::vector<std::int64_t> neighbors = {-1, 1, -1, -1, -1, 0};
  mesh.index_bytes = 8;
  mesh.simplices = wide.data();
  mesh.neighbors = neighbors.data();
  CHECK(circumspect_verdict_holds(check("delaunay", &mesh).verdict.get()) == 1);
  const std::vector<std::int64_t> exchanged = {1, -1, -1, -1, -1, 0};
  mesh.neighbors = exchanged.data();
  CHECK(circumspect_verdict_holds(check("delaunay", &mesh).verdict.get()) == 0);
  for (const char* const claim : {"complex", "convex-hull", "surface-delaunay"}) {
    CHECK(check(claim, &mesh).status == CIRCUMSPECT_INVALID_ARGUMENT);
    CHECK(has(circumspect_last_error(), "expected no neighbors beside the claim "));
  }
  mesh.neighbors = nullptr;
  // The weight of the last point pulls it out of the ball.
  const std::vector<double> weights = {0, 0, 0, -1};
  mesh.weights = weights.data();
  CHECK(circumspect_verdict_holds(check("weighted-delaunay", &mesh).verdict.get()) == 0);
  CHECK(circumspect_verdict_holds(check("delaunay", &mesh).verdict.get()) == 1);
  const std::array<const char*, 4> weight_texts = {"0", "-1/3", "0", "0"};
  mesh.weights = nullptr;
  mesh.exact_weights = weight_texts.data();
  CHECK(circumspect_verdict_holds(check("weighted-delaunay", &mesh).verdict.get()) == 1);
  // Texts mean the same weights as doubles.
  const std::array<const char*, 4> same_texts = {"0", "0", "0", "-1"};
  mesh.exact_weights = same_texts.data();
  CHECK(circumspect_verdict_holds(check("weighted-delaunay", &mesh).verdict.get()) == 0);
  // On the circle as texts, where their doubles are beside it: 0.6² + 0.8² = 1.
  const std::array<const char*, 8> texts = {"0", "1", "1", "0", "0.6", "0.8", "-3/5", "4/5"};
  mesh = mesh_of(kPoints, kRight);
  mesh.coordinates = nullptr;
  mesh.exact_coordinates = texts.data();
  const std::vector<std::int32_t> fan = {0, 1, 2, 0, 3, 1};
  mesh.simplices = fan.data();
  const Checked exact = check("delaunay", &mesh);
  REQUIRE(exact.status == CIRCUMSPECT_OK);
  CHECK(circumspect_verdict_holds(exact.verdict.get()) == 1);
  CHECK(circumspect_verdict_unique(exact.verdict.get()) == 0);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.by_definition = 1;
  options.oriented = 1;
  options.threads = 2;
  options.mesh_name = "a\nb";
  const Checked named = check("delaunay", &mesh, nullptr, &options);
  REQUIRE(named.status == CIRCUMSPECT_OK);
  CHECK(has(circumspect_verdict_text(named.verdict.get()), "a\\x0ab"));
  CHECK(has(circumspect_verdict_json(named.verdict.get()), "\"definition\""));
  options.without_json = 1;
  CHECK(std::string(
            circumspect_verdict_json(check("delaunay", &mesh, nullptr, &options).verdict.get()))
            .empty());
}

TEST_CASE("a page shows the witnesses of a verdict that was asked for with pictures") {
  const circumspect_mesh mesh = mesh_of(kPoints, kWrong);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.mesh_name = "</script><b>";
  circumspect_document* page = nullptr;
  const Checked without = check("delaunay", &mesh, nullptr, &options);
  CHECK(circumspect_verdict_page(without.verdict.get(), &page) == CIRCUMSPECT_NONE);
  CHECK(page == nullptr);
  CHECK(has(circumspect_last_error(), "asked for with_pictures, found one without"));
  options.with_pictures = 1;
  for (const int without_json : {0, 1}) {
    options.without_json = without_json;
    const Checked found = check("delaunay", &mesh, nullptr, &options);
    REQUIRE(circumspect_verdict_page(found.verdict.get(), &page) == CIRCUMSPECT_OK);
    const char* const text = circumspect_document_text(page);
    CHECK(has(text, "<!DOCTYPE html>"));
    CHECK(has(text, "fails: delaunay &lt;/script&gt;&lt;b&gt; delaunay.facet-not-local"));
    CHECK(has(text, R"("pictures":[{)"));
    CHECK(!has(text, "</script><b>"));
    circumspect_document_free(page);
  }
  // The options of the first version end before the pictures.
  options.struct_size = offsetof(circumspect_options, with_pictures);
  const Checked earlier = check("delaunay", &mesh, nullptr, &options);
  REQUIRE(earlier.status == CIRCUMSPECT_OK);
  CHECK(circumspect_verdict_page(earlier.verdict.get(), &page) == CIRCUMSPECT_NONE);
  CHECK(circumspect_verdict_page(nullptr, &page) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_verdict_page(earlier.verdict.get(), nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
}

TEST_CASE("a domain, moved or not") {
  const std::vector<std::int32_t> halves = {0, 1, 2, 0, 2, 3};
  const circumspect_mesh mesh = mesh_of(kCorners, halves);
  circumspect_domain domain = square();
  CHECK(circumspect_verdict_holds(check("cdt", &mesh, &domain).verdict.get()) == 1);
  std::vector<double> rounded = kCorners;
  rounded[2] = 1 + 1e-12;
  const circumspect_mesh moved = mesh_of(rounded, halves);
  CHECK(circumspect_verdict_holds(check("cdt", &moved, &domain).verdict.get()) == 0);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.within = "1e-9";
  const Checked within = check("cdt", &moved, &domain, &options);
  REQUIRE(within.status == CIRCUMSPECT_OK);
  CHECK(has(circumspect_verdict_text(within.verdict.get()), "within"));
  // Exactly as far as it was moved, and no less; the square of a sixteenth is far less.
  rounded[2] = 1.0625;
  options.within = "0.0625";
  CHECK(circumspect_verdict_holds(check("cdt", &moved, &domain, &options).verdict.get()) == 1);
  options.within = "0.0624";
  CHECK(circumspect_verdict_holds(check("cdt", &moved, &domain, &options).verdict.get()) == 0);
  options.within = "-1";
  CHECK(check("cdt", &moved, &domain, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  options.within = "1";
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  // Crossing diagonals do not form a piecewise linear complex.
  const std::vector<std::int64_t> crossing = {0, 2, 1, 3};
  domain.segment_count = 2;
  domain.segments = crossing.data();
  CHECK(check("cdt", &mesh, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "plc.crossing-segments"));
  // It is open, so its kind cannot be told.
  domain.segment_count = 1;
  CHECK(check("cdt", &mesh, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "enclose nothing"));
  domain.kind = CIRCUMSPECT_HULL;
  CHECK(circumspect_verdict_holds(check("cdt", &mesh, &domain).verdict.get()) == 1);
  domain.kind = 7;
  CHECK(check("cdt", &mesh, &domain).status == CIRCUMSPECT_INVALID_ARGUMENT);
}

TEST_CASE("threads do not see one another's errors") {
  const circumspect_mesh mesh = mesh_of(kPoints, kRight);
  std::atomic<int> wrong = 0;
  const auto ask = [&](const char* claim, circumspect_status expected) {
    for (int i = 0; i < 50; ++i) {
      circumspect_verdict* verdict = nullptr;
      const circumspect_status status = circumspect_check(claim, &mesh, nullptr, nullptr, &verdict);
      const bool is_silent = circumspect_last_error()[0] == '\0';
      if (status != expected || is_silent != (status == CIRCUMSPECT_OK)) ++wrong;
      circumspect_verdict_free(verdict);
    }
  };
  std::thread first([&] { ask("delaunay", CIRCUMSPECT_OK); });
  std::thread second([&] { ask("nonsense", CIRCUMSPECT_INVALID_ARGUMENT); });
  first.join();
  second.join();
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace circumspect::c
