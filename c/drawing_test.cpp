// Points and domains that the C interface draws.
#include <cstddef>
#include <cstdint>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

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

}  // namespace
}  // namespace circumspect::c
