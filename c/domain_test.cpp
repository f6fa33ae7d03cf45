// Which part of a domain is filled, and which of its polygons are joined.
#include <cstddef>
#include <string>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

// A square in a square, turned the other way about.
const std::vector<double> kNested = {0, 0, 3, 0, 3, 3, 0, 3, 1, 1, 2, 1, 2, 2, 1, 2};
const std::vector<std::int64_t> kLoops = {0, 1, 1, 2, 2, 3, 3, 0, 4, 7, 7, 6, 6, 5, 5, 4};

circumspect_domain nested() { return of_segments(kNested, kLoops); }

TEST_CASE("what is filled is as the kind says, or the regions") {
  circumspect_domain domain = nested();
  CHECK(simplices_in(domain) == 10);
  for (const circumspect_domain_kind kind : {CIRCUMSPECT_EVEN_ODD, CIRCUMSPECT_WINDING}) {
    domain.kind = kind;
    CHECK(simplices_in(domain) == 8);
  }
  const std::vector<std::int64_t> same_way = {0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4};
  domain.segments = same_way.data();
  CHECK(simplices_in(domain) == 10);
  domain.kind = CIRCUMSPECT_EVEN_ODD;
  CHECK(simplices_in(domain) == 8);
  domain = nested();
  const double inside[] = {1.5, 1.25};
  domain.region_count = 1;
  domain.region_seeds = inside;
  CHECK(simplices_in(domain) == 2);
  const char* const between[] = {"1/3", "1/3"};
  domain.region_seeds = nullptr;
  domain.exact_region_seeds = between;
  CHECK(simplices_in(domain) == 8);
  // A program compiled before there were regions has none.
  domain.struct_size = offsetof(circumspect_domain, region_count);
  CHECK(simplices_in(domain) == 10);
}

TEST_CASE("kinds and regions that make no sense are refused") {
  const auto refused = [](auto change, circumspect_status expected, const std::string& message) {
    circumspect_domain domain = nested();
    change(domain);
    check_refused(domain, expected, message);
  };
  static const double outside[] = {9, 9};
  static const double on_wall[] = {1.5, 0};
  static const std::vector<std::int64_t> mixed = {0, 1, 1, 2, 2, 3, 0, 3, 4, 7, 7, 6, 6, 5, 5, 4};
  refused([](auto& domain) { domain.kind = 5; }, CIRCUMSPECT_INVALID_ARGUMENT, "found 5");
  refused([](auto& domain) { domain.region_count = -1; }, CIRCUMSPECT_INVALID_ARGUMENT,
          "a number of regions, found -1");
  refused([](auto& domain) { domain.region_count = 1; }, CIRCUMSPECT_INVALID_ARGUMENT, "NULL");
  const auto with_seed = [](const double* seed) {
    return [seed](auto& domain) {
      domain.region_count = 1;
      domain.region_seeds = seed;
    };
  };
  refused(with_seed(outside), CIRCUMSPECT_INPUT_FAULT, "region 0 in something enclosed");
  refused(with_seed(on_wall), CIRCUMSPECT_INPUT_FAULT, "found it on a wall");
  refused(
      [&](auto& domain) {
        with_seed(on_wall)(domain);
        domain.kind = CIRCUMSPECT_HULL;
      },
      CIRCUMSPECT_INVALID_ARGUMENT, "beside another kind");
  refused(
      [](auto& domain) {
        domain.segments = mixed.data();
        domain.kind = CIRCUMSPECT_WINDING;
      },
      CIRCUMSPECT_INPUT_FAULT, "turned against others");
}

TEST_CASE("polygons of one plane are one, where that is asked for") {
  // A tetrahedron with a side that is cut from the middle of an edge.
  const std::vector<double> points = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 1, 0};
  const std::vector<std::int64_t> starts = {0, 1, 2, 3, 4, 5};
  const std::vector<std::int64_t> lines = {0, 3, 6, 9, 12, 16};
  const std::vector<std::int64_t> corners = {0, 1, 4, 0, 4, 2, 0, 1, 3, 0, 2, 3, 1, 4, 2, 3};
  circumspect_domain domain = of_polygons(points, starts, lines, corners);
  circumspect_mesh mesh = CIRCUMSPECT_MESH;
  const std::vector<std::int32_t> one = {0, 1, 4, 3};
  mesh.dimension = 3;
  mesh.point_count = 5;
  mesh.coordinates = points.data();
  mesh.simplex_count = 1;
  mesh.vertices_of_simplex = 4;
  mesh.simplices = one.data();
  const std::vector<std::int64_t> edges = {0, 2, 2, 3, 2, 4};  // of what is left out
  mesh.edge_count = 3;
  mesh.edges = edges.data();
  const Checked cut = check("plc-triangulation", &mesh, &domain);
  CHECK(has(circumspect_verdict_text(cut.verdict.get()), "polygon 1"));
  domain.merge_coplanar = 1;
  const Checked joined = check("plc-triangulation", &mesh, &domain);
  CHECK(has(circumspect_verdict_text(joined.verdict.get()), "0, joined of 2"));
}

// Two rings of one polygon, and a third polygon in the hole.
TEST_CASE("polygons of the plane are rings") {
  circumspect_domain domain = nested();
  domain.segment_count = 0;
  domain.polygon_count = 1;
  const std::vector<std::int64_t> starts = {0, 2, 3};
  const std::vector<std::int64_t> lines = {0, 4, 8, 12};
  const std::vector<std::int64_t> corners = {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7};
  domain.polygon_starts = starts.data();
  domain.line_starts = lines.data();
  domain.corners = corners.data();
  CHECK(simplices_in(domain) == 8);
  domain.kind = CIRCUMSPECT_ENCLOSED;
  CHECK(simplices_in(domain) == 10);
  domain.kind = CIRCUMSPECT_KIND_BY_WALLS;
  domain.polygon_count = 2;
  CHECK(simplices_in(domain) == 10);
  const std::vector<std::int64_t> short_lines = {0, 4, 6, 10};
  domain.line_starts = short_lines.data();
  check_refused(domain, CIRCUMSPECT_INVALID_ARGUMENT, "rings of at least 3 corners in the plane");
  domain.line_starts = lines.data();
  const std::int64_t owner = 0;
  const double seed[] = {1.5, 1.5};
  domain.polygon_hole_count = 1;
  domain.polygons_of_holes = &owner;
  domain.polygon_hole_seeds = seed;
  check_refused(domain, CIRCUMSPECT_INVALID_ARGUMENT, "whose rings bound the holes");
}

TEST_CASE("segments that meet anywhere are resolved if asked") {
  const std::vector<double> points = {0, 0, 4, 0, 4, 4, 0, 4, 4, 4};
  const std::vector<std::int64_t> edges = {0, 1, 1, 2, 4, 3, 3, 0, 0, 2, 1, 3};
  circumspect_domain domain = of_segments(points, edges);
  check_refused(domain, CIRCUMSPECT_INPUT_FAULT, "plc.duplicate-vertex");
  domain.resolve = 1;
  CHECK(simplices_in(domain) == 4);
  const std::vector<std::int64_t> unknown = {0, 1, 1, 2, 4, 3, 3, 0, 0, 2, 1, 5};
  domain.segments = unknown.data();
  check_refused(domain, CIRCUMSPECT_INPUT_FAULT, "expected corners among 5 points, found 5");
  // A program compiled before there was such a choice has none.
  domain.segments = edges.data();
  domain.struct_size = offsetof(circumspect_domain, resolve);
  check_refused(domain, CIRCUMSPECT_INPUT_FAULT, "plc.duplicate-vertex");
}

TEST_CASE("equal points of a domain are merged with those of the mesh") {
  const std::vector<double> points = {0, 0, 4, 0, 4, 4, 0, 4, 0, 0};
  circumspect_domain domain = of_segments(points, kLoops);
  const std::vector<std::int64_t> edges = {0, 1, 1, 2, 2, 3, 3, 4, 4, 0};
  domain.segment_count = 5;
  domain.segments = edges.data();
  const std::vector<double> corners = {0, 0, 4, 0, 4, 4, 0, 4};
  const std::vector<std::int32_t> halves = {0, 1, 2, 0, 2, 3};
  const circumspect_mesh mesh = mesh_of(corners, halves);
  CHECK(check(nullptr, &mesh, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.merge_equal_points = 1;
  const Checked merged = check(nullptr, &mesh, &domain, &options);
  REQUIRE(merged.status == CIRCUMSPECT_OK);
  CHECK(circumspect_verdict_holds(merged.verdict.get()) == 1);
  CHECK(has(circumspect_verdict_claim(merged.verdict.get()), "cdt"));
  // A ring whose last corner equals its first, and one whose corners repeat, is the same ring.
  const std::vector<std::int64_t> ring = {0, 1, 2, 3, 4}, one = {0, 1}, five = {0, 5};
  domain.segment_count = 0;
  domain.polygon_count = 1;
  domain.polygon_starts = one.data();
  domain.line_starts = five.data();
  domain.corners = ring.data();
  const Checked of_ring = check(nullptr, &mesh, &domain, &options);
  REQUIRE(of_ring.status == CIRCUMSPECT_OK);
  CHECK(circumspect_verdict_holds(of_ring.verdict.get()) == 1);
  const std::vector<std::int64_t> beyond = {0, 1, 2, 9};
  const circumspect_domain unknown = of_segments(points, beyond);
  CHECK(check(nullptr, &mesh, &unknown, &options).status == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "expected corners among 5 points, found 9"));
  // What is wrong is named by the indices that were given: 1 is another name of 0.
  const std::vector<double> more = {0, 0, 0, 0, 4, 0, 4, 4, 0, 4};
  const std::vector<std::int64_t> crossed = {1, 3, 2, 4};
  const circumspect_domain crossing = of_segments(more, crossed);
  CHECK(check(nullptr, &mesh, &crossing, &options).status == CIRCUMSPECT_INPUT_FAULT);
  INFO(circumspect_last_error());
  CHECK(has(circumspect_last_error(), "segment 0 3"));
  CHECK(has(circumspect_last_error(), "segment 2 4"));
}

}  // namespace
}  // namespace circumspect::c
