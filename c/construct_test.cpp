// What the C interface builds and compares, and its predicates.
#include <array>
#include <cstddef>
#include <string>
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
  REQUIRE(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_OK);
  CHECK(circumspect_triangulation_simplices(built, 4, nullptr) == 1);
  circumspect_triangulation_free(built);
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
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
  domain.dimension = 3;
  domain.point_count = 6;
  domain.coordinates = points.data();
  domain.polygon_count = 8;
  domain.polygon_starts = starts.data();
  domain.line_starts = lines.data();
  domain.corners = inwards.data();
  circumspect_triangulation* built = nullptr;
  CHECK(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_NONE);
  CHECK(built == nullptr);
  CHECK(has(circumspect_last_error(), "found none: it shows at"));
  domain.corners = outwards.data();
  REQUIRE(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_OK);
  CHECK(circumspect_triangulation_simplices(built, 4, nullptr) >= 3);
  circumspect_triangulation_free(built);
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
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
  domain.dimension = 3;
  domain.point_count = 8;
  domain.coordinates = points.data();
  domain.polygon_count = 7;
  domain.polygon_starts = polygons.data();
  domain.line_starts = lines.data();
  domain.corners = corners.data();
  domain.polygon_hole_count = 1;
  domain.polygons_of_holes = owners.data();
  domain.polygon_hole_seeds = seeds.data();
  const auto tetrahedra = [&] {
    circumspect_triangulation* built = nullptr;
    REQUIRE(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_OK);
    const std::int64_t count = circumspect_triangulation_simplices(built, 4, nullptr);
    circumspect_triangulation_free(built);
    return count;
  };
  const std::int64_t around_the_pit = tetrahedra();
  domain.polygon_hole_seeds = nullptr;
  const std::array<const char*, 3> exact = {"5/3", "5/3", "0"};
  domain.exact_polygon_hole_seeds = exact.data();
  CHECK(tetrahedra() == around_the_pit);
  domain.exact_polygon_hole_seeds = nullptr;
  domain.polygon_hole_seeds = seeds.data();
  // The members of the first version end before the holes of polygons; later members are not read.
  domain.struct_size = offsetof(circumspect_domain, polygon_hole_count);
  CHECK(tetrahedra() == around_the_pit + 1);  // the pit is the tetrahedron 4 5 6 7
  domain.struct_size = sizeof domain;
  circumspect_triangulation* built = nullptr;
  const auto refused = [&](circumspect_status status, const char* message) {
    CHECK(circumspect_constrained_delaunay(&domain, &built) == status);
    INFO(circumspect_last_error());
    CHECK(has(circumspect_last_error(), message));
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

TEST_CASE("points are drawn by family and seed, and judged where they lie") {
  circumspect_drawing* drawing = nullptr;
  REQUIRE(circumspect_generate("duplicates", 2, 9, 7, &drawing) == CIRCUMSPECT_OK);
  const circumspect_mesh* points = circumspect_drawing_mesh(drawing);
  CHECK(points->dimension == 2);
  CHECK(points->point_count > 3);
  CHECK(points->weights == nullptr);
  circumspect_triangulation* built = nullptr;
  CHECK(circumspect_delaunay(points, &built) == CIRCUMSPECT_INPUT_FAULT);  // equal points
  circumspect_drawing_free(drawing);

  const auto numbers = [](std::uint64_t seed) {
    circumspect_drawing* drawn = nullptr;
    REQUIRE(circumspect_generate("submerged+moved", 3, 12, seed, &drawn) == CIRCUMSPECT_OK);
    const circumspect_mesh mesh = *circumspect_drawing_mesh(drawn);
    REQUIRE(mesh.point_count > 4);
    REQUIRE(mesh.weights != nullptr);
    std::vector<double> all(mesh.coordinates, mesh.coordinates + 3 * mesh.point_count);
    all.insert(all.end(), mesh.weights, mesh.weights + mesh.point_count);
    circumspect_drawing_free(drawn);
    return all;
  };
  CHECK(numbers(1) == numbers(1));
  CHECK(numbers(1) != numbers(2));

  REQUIRE(circumspect_generate("grid", 2, 8, 1, &drawing) == CIRCUMSPECT_OK);
  REQUIRE(circumspect_delaunay(circumspect_drawing_mesh(drawing), &built) == CIRCUMSPECT_OK);
  const std::int64_t* indices = nullptr;
  circumspect_mesh mesh = *circumspect_drawing_mesh(drawing);
  mesh.simplex_count = circumspect_triangulation_simplices(built, 3, &indices);
  mesh.vertices_of_simplex = 3;
  mesh.index_bytes = 8;
  mesh.simplices = indices;
  const Checked judged = check("delaunay", &mesh);
  REQUIRE(judged.verdict != nullptr);
  CHECK(circumspect_verdict_holds(judged.verdict.get()) == 1);
  CHECK(circumspect_verdict_canonical(judged.verdict.get()) == 1);
  circumspect_triangulation_free(built);
  circumspect_drawing_free(drawing);
}

TEST_CASE("domains are drawn by family and seed, with the holes of their polygons, and filled") {
  circumspect_drawing* drawing = nullptr;
  std::int64_t holes = 0;
  std::int64_t polygon_holes = 0;
  std::size_t filled = 0;
  for (const char* const family : {"furnished-boxes", "planar-segments"}) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      REQUIRE(circumspect_generate_domain(family, 12, seed, &drawing) == CIRCUMSPECT_OK);
      const circumspect_domain* const domain = circumspect_drawing_domain(drawing);
      REQUIRE(domain != nullptr);
      CHECK(circumspect_drawing_mesh(drawing)->point_count == domain->point_count);
      holes += domain->hole_count;
      polygon_holes += domain->polygon_hole_count;
      circumspect_triangulation* built = nullptr;
      const circumspect_status status = circumspect_constrained_delaunay(domain, &built);
      REQUIRE((status == CIRCUMSPECT_OK || status == CIRCUMSPECT_NONE));
      circumspect_mesh mesh = *circumspect_drawing_mesh(drawing);
      if (status == CIRCUMSPECT_OK) {
        const std::int64_t* indices = nullptr;
        mesh.vertices_of_simplex = domain->dimension + 1;
        mesh.simplex_count =
            circumspect_triangulation_simplices(built, mesh.vertices_of_simplex, &indices);
        mesh.index_bytes = 8;
        mesh.simplices = indices;
        if (domain->dimension == 3) {
          mesh.triangle_count = circumspect_triangulation_simplices(built, 3, &mesh.triangles);
        }
        mesh.edge_count = circumspect_triangulation_simplices(built, 2, &mesh.edges);
        const Checked judged = check("cdt", &mesh, domain);
        CHECK(circumspect_verdict_holds(judged.verdict.get()) == 1);
        ++filled;
      }
      circumspect_triangulation_free(built);
      circumspect_drawing_free(drawing);
    }
  }
  CHECK(holes > 5);
  CHECK(polygon_holes > 2);
  CHECK(filled > 20);
  REQUIRE(circumspect_generate("grid", 2, 8, 1, &drawing) == CIRCUMSPECT_OK);
  CHECK(circumspect_drawing_domain(drawing) == nullptr);
  circumspect_drawing_free(drawing);
}

TEST_CASE("exact predicates") {
  int sign = 7;
  const std::array<double, 6> turn = {0, 0, 1, 0, 0, 1};
  CHECK(circumspect_orientation(2, turn.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 1);
  // On a line, where doubles round to either side of it.
  const std::array<double, 6> line = {0.1, 0.1, 0.2, 0.2, 0.3, 0.3};
  CHECK(circumspect_orientation(2, line.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 0);
  const std::array<double, 8> inside = {0, 0, 1, 0, 0, 1, 0.9, 0.9};
  CHECK(circumspect_in_ball(2, inside.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 1);
  const std::array<const char*, 8> on = {"0", "0", "1/3", "0", "0", "1/3", "1/3", "1/3"};
  CHECK(circumspect_in_ball_exact(2, on.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 0);
  CHECK(circumspect_orientation_exact(2, on.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 1);
  const std::array<double, 8> flat = {0, 0, 1, 0, 2, 0, 0.9, 0.9};
  CHECK(circumspect_in_ball(2, flat.data(), &sign) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(circumspect_in_ball(0, flat.data(), &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_in_ball(-3, flat.data(), &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_in_ball(2, nullptr, &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_in_ball(2, flat.data(), nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
  const std::array<const char*, 6> malformed = {"0", "0", "1", "one", "0", "1"};
  CHECK(circumspect_orientation_exact(2, malformed.data(), &sign) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "found one in the coordinates at place 3"));
  const std::array<const char*, 6> null = {"0", "0", "1", nullptr, "0", "1"};
  CHECK(circumspect_orientation_exact(2, null.data(), &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
}

TEST_CASE("facts about points") {
  const std::vector<double> square = {0, 0, 5, 5, 1, 0, 0, 1, 0, 0, 1, 1};
  const circumspect_mesh mesh = mesh_of(square, {});
  int unique = 7;
  circumspect_document* document = nullptr;
  REQUIRE(circumspect_inspect(&mesh, &unique, &document) == CIRCUMSPECT_OK);
  CHECK(unique == 0);
  std::string facts = circumspect_document_text(document);
  std::erase_if(facts, [](char c) { return c == ' ' || c == '\n'; });
  CHECK(facts ==
        R"({"points":6,"dimension":2,"repeated":[[0,4]],"unique":false,"cospherical":[0,2,3,5]})");
  circumspect_document_free(document);
  const circumspect_mesh none = mesh_of({}, {});
  REQUIRE(circumspect_inspect(&none, &unique, &document) == CIRCUMSPECT_OK);
  CHECK(unique == 1);
  CHECK(has(circumspect_document_text(document), "-1"));
  circumspect_document_free(document);
  CHECK(circumspect_inspect(nullptr, &unique, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_inspect(&mesh, nullptr, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_inspect(&mesh, &unique, nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
}

TEST_CASE("comparisons and certificates") {
  const circumspect_mesh right = mesh_of(kPoints, kRight);
  const circumspect_mesh wrong = mesh_of(kPoints, kWrong);
  int answer = 7;
  circumspect_document* document = nullptr;
  REQUIRE(circumspect_compare(&right, &wrong, &answer, &document) == CIRCUMSPECT_OK);
  CHECK(answer == 0);
  CHECK(has(circumspect_document_text(document), "only_in_a"));
  circumspect_document_free(document);
  REQUIRE(circumspect_compare(&right, &right, &answer, &document) == CIRCUMSPECT_OK);
  CHECK(answer == 1);
  circumspect_document_free(document);
  for (const circumspect_mesh* mesh : {&right, &wrong}) {
    REQUIRE(circumspect_certify("delaunay", mesh, &answer, &document) == CIRCUMSPECT_OK);
    CHECK(answer == (mesh == &right ? 1 : 0));
    CHECK(std::string(circumspect_document_text(document)).size() > 20);
    circumspect_document_free(document);
  }
  CHECK(circumspect_certify("cdt", &right, &answer, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_certify("delaunay", nullptr, &answer, &document) ==
        CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_compare(nullptr, &right, &answer, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_compare(&right, &right, nullptr, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_compare(&right, &right, &answer, nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace circumspect::c
