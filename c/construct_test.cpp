// What the C interface builds.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

TEST_CASE("references are built, and domains of space taken") {
  circumspect_triangulation* built = nullptr;
  const circumspect_mesh mesh = mesh_of(kPoints, {});
  REQUIRE(circumspect_delaunay(&mesh, &built) == CIRCUMSPECT_OK);
  CHECK(circumspect_triangulation_dimension(built) == 2);
  const std::int64_t* indices = nullptr;
  REQUIRE(circumspect_triangulation_simplices(built, 3, &indices) == 2);
  CHECK(indices[0] + indices[1] + indices[2] + indices[3] + indices[4] + indices[5] == 9);
  CHECK(circumspect_triangulation_simplices(built, 2, &indices) == 0);
  CHECK(indices == nullptr);
  CHECK(circumspect_triangulation_simplices(built, -1, nullptr) == 0);
  circumspect_triangulation_free(built);
  circumspect_domain domain = tetrahedron();
  CHECK(simplices_in(domain) == 1);
  const std::vector<std::int64_t> backwards = {0, 3, 2, 9, 12};
  domain.line_starts = backwards.data();
  CHECK(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(built == nullptr);
  domain.line_starts = nullptr;
  CHECK(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_INVALID_ARGUMENT);
  const std::vector<double> equal = {0, 0, 1, 0, 0, 1, 1, 0};
  const circumspect_mesh repeated = mesh_of(equal, {});
  CHECK(circumspect_delaunay(&repeated, &built) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "expected distinct points, found points 1 and 3 equal"));
}

// Are all simplices of `vertices` positively oriented?
bool are_positive(const circumspect_triangulation* built, std::int64_t vertices,
                  const std::vector<double>& points) {
  const std::int64_t* indices = nullptr;
  const std::int64_t count = circumspect_triangulation_simplices(built, vertices, &indices);
  bool are = count > 0;
  for (std::int64_t s = 0; s < count; ++s) {
    std::vector<double> corners;
    for (std::int64_t i = 0; i < vertices; ++i) {
      const auto first = points.begin() + indices[s * vertices + i] * (vertices - 1);
      corners.insert(corners.end(), first, first + vertices - 1);
    }
    int sign = 0;
    CHECK(circumspect_orientation(vertices - 1, corners.data(), &sign) == CIRCUMSPECT_OK);
    are = are && sign > 0;
  }
  return are;
}

TEST_CASE("simplices are positively oriented, in whatever order the points are") {
  for (const bool is_reversed : {false, true}) {
    std::vector<double> plane = {0, 0, 4, 0, 4, 4, 0, 4, 1, 2, 3, 1};
    std::vector<double> space = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 1, 1, 1, 4, 4, 5};
    if (is_reversed) std::reverse(plane.begin(), plane.end());
    if (is_reversed) std::reverse(space.begin(), space.end());
    circumspect_triangulation* built = nullptr;
    circumspect_mesh mesh = mesh_of(plane, {});
    REQUIRE(circumspect_delaunay(&mesh, &built) == CIRCUMSPECT_OK);
    CHECK(are_positive(built, 3, plane));
    circumspect_triangulation_free(built);
    const circumspect_domain hull = of_segments(plane, {});
    REQUIRE(circumspect_constrained_delaunay(&hull, &built) == CIRCUMSPECT_OK);
    CHECK(are_positive(built, 3, plane));
    circumspect_triangulation_free(built);
    mesh = mesh_of(space, {});
    mesh.dimension = 3;
    mesh.point_count = 6;
    REQUIRE(circumspect_delaunay(&mesh, &built) == CIRCUMSPECT_OK);
    CHECK(are_positive(built, 4, space));
    circumspect_triangulation_free(built);
  }
}

TEST_CASE("Schoenhardt's polyhedron has none, and that is said") {
  const std::vector<double> points = {10, 0, 0,  -5, 9, 0,  -5, -9,  0,
                                      9,  5, 10, -9, 5, 10, 0,  -10, 10};
  const std::vector<std::int64_t> starts = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<std::int64_t> lines = {0, 3, 6, 9, 12, 15, 18, 21, 24};
  // The diagonals of its sides bend inwards; the other ones bend outwards.
  const std::vector<std::int64_t> inwards = {0, 1, 2, 3, 4, 5, 0, 1, 4, 0, 4, 3,
                                             1, 2, 5, 1, 4, 5, 0, 2, 3, 2, 3, 5};
  const std::vector<std::int64_t> outwards = {0, 1, 2, 3, 4, 5, 0, 1, 3, 1, 4, 3,
                                              1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5};
  circumspect_domain domain = of_polygons(points, starts, lines, inwards);
  check_refused(domain, CIRCUMSPECT_NONE, "found none: it shows at");
  domain.corners = outwards.data();
  CHECK(simplices_in(domain) >= 3);
}

TEST_CASE("a polygon has the holes that seeds say, and a program of an earlier version has none") {
  // A tetrahedron whose floor has a triangular hole: the lines of a pit with its tip above it.
  const std::vector<double> points = {0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9,
                                      1, 1, 0, 4, 1, 0, 1, 4, 0, 2, 2, 2};
  const std::vector<std::int64_t> polygons = {0, 1, 2, 3, 5, 6, 7, 8};
  const std::vector<std::int64_t> lines = {0, 3, 6, 9, 12, 15, 18, 21, 24};
  const std::vector<std::int64_t> corners = {0, 1, 3, 1, 2, 3, 0, 2, 3, 0, 1, 2,
                                             4, 5, 6, 4, 5, 7, 5, 6, 7, 4, 6, 7};
  const std::vector<std::int64_t> owners = {3};
  const std::vector<double> seeds = {2, 2, 0};
  circumspect_domain domain = of_polygons(points, polygons, lines, corners);
  domain.polygon_hole_count = 1;
  domain.polygons_of_holes = owners.data();
  domain.polygon_hole_seeds = seeds.data();
  const std::int64_t around_the_pit = simplices_in(domain);
  domain.polygon_hole_seeds = nullptr;
  const std::array<const char*, 3> exact = {"5/3", "5/3", "0"};
  domain.exact_polygon_hole_seeds = exact.data();
  CHECK(simplices_in(domain) == around_the_pit);
  domain.exact_polygon_hole_seeds = nullptr;
  domain.polygon_hole_seeds = seeds.data();
  // The members of the first version end before the holes of polygons; later members are not read.
  domain.struct_size = offsetof(circumspect_domain, polygon_hole_count);
  CHECK(simplices_in(domain) == around_the_pit + 1);  // the pit is the tetrahedron 4 5 6 7
  domain.struct_size = sizeof domain;
  const auto refused = [&](circumspect_status status, const char* message) {
    check_refused(domain, status, message);
  };
  for (const std::int64_t wrong : {-1, 7}) {
    domain.polygons_of_holes = &wrong;
    refused(CIRCUMSPECT_INVALID_ARGUMENT, "expected hole 0 in one of 7 polygons");
  }
  domain.polygons_of_holes = nullptr;
  refused(CIRCUMSPECT_INVALID_ARGUMENT, "expected polygons_of_holes, found NULL");
  domain.polygons_of_holes = owners.data();
  domain.polygon_hole_seeds = nullptr;
  refused(CIRCUMSPECT_INVALID_ARGUMENT, "found NULL");
  domain.polygon_hole_seeds = points.data();  // a corner of the floor
  refused(CIRCUMSPECT_INPUT_FAULT, "plc.polygon-hole-seed");
  domain.polygon_hole_count = -1;
  refused(CIRCUMSPECT_INVALID_ARGUMENT, "a number of holes of polygons, found -1");
}

}  // namespace
}  // namespace circumspect::c
