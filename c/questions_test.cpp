// What the C interface says about hulls, surfaces and Voronoi diagrams, and what it refuses.
#include <cstddef>
#include <string>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

TEST_CASE("demands are named by words, and asked of the claim that has them") {
  const std::vector<double> points = {0, 0, 4, 0, 4, 4, 0, 4, 2, 0};
  const std::vector<std::int32_t> edges = {0, 1, 1, 2, 2, 3, 3, 0};
  circumspect_mesh mesh = mesh_of(points, edges);
  mesh.vertices_of_simplex = 2;
  mesh.simplex_count = 4;
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  const auto holds = [&](const char* claim, const char* demands) {
    options.demands = demands;
    return circumspect_verdict_holds(check(claim, &mesh, nullptr, &options).verdict.get());
  };
  CHECK(holds("convex-hull", nullptr) == 1);
  CHECK(holds("convex-hull", "only-extreme") == 1);
  CHECK(holds("convex-hull", "only-extreme all-boundary-points") == 0);
  CHECK(holds("complex", "allow-unused closed manifold connected") == 1);
  CHECK(holds("complex", "closed") == 0);
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "expected demands of the claim delaunay, which has none"));
  options.demands = "extreme";
  CHECK(check("convex-hull", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "all-boundary-points only-extreme; found 'extreme'"));
}

TEST_CASE("a mesh alone may be asked to list its simplices in one sense, or in a named one") {
  const std::vector<double> points = {0, 0, 1, 0, 1, 1, 0, 1};
  const std::vector<std::int32_t> positive = {0, 1, 2, 0, 2, 3}, negative = {1, 0, 2, 2, 0, 3},
                                  mixed = {0, 1, 2, 2, 0, 3};
  const auto holds = [&](const std::vector<std::int32_t>& rows, bool oriented,
                         const char* demands = nullptr) {
    const circumspect_mesh mesh = mesh_of(points, rows);
    circumspect_options options = CIRCUMSPECT_OPTIONS;
    options.oriented = oriented ? 1 : 0;
    options.demands = demands;
    return circumspect_verdict_holds(check("complex", &mesh, nullptr, &options).verdict.get()) == 1;
  };
  for (const auto& rows : {positive, negative, mixed}) {
    CHECK(holds(rows, false));
    CHECK(holds(rows, true) == (rows != mixed));
    CHECK(holds(rows, false, "oriented=positive") == (rows == positive));
    CHECK(holds(rows, false, "oriented=negative") == (rows == negative));
  }
}

TEST_CASE("cells are judged within a distance and a box") {
  const std::vector<double> sites = {0, 0, 4, 0, 4, 4, 0, 4};
  std::vector<double> vertices = {2, 2.5};
  const std::vector<std::int64_t> starts = {0, 2, 4, 6, 8}, corners = {0, -1, 0, -1, 0, -1, 0, -1},
                                  ridges = {0, 1, 1, 2, 2, 3, 3, 0};
  circumspect_voronoi diagram = CIRCUMSPECT_VORONOI;
  diagram.dimension = 2;
  diagram.site_count = 4;
  diagram.sites = sites.data();
  diagram.vertex_count = 1;
  diagram.vertices = vertices.data();
  diagram.cell_starts = starts.data();
  diagram.corners = corners.data();
  diagram.ridge_count = 4;
  diagram.ridges = ridges.data();
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  const auto holds = [&] {
    circumspect_verdict* verdict = nullptr;
    REQUIRE(circumspect_check_voronoi(&diagram, &options, &verdict) == CIRCUMSPECT_OK);
    const int answer = circumspect_verdict_holds(verdict);
    circumspect_verdict_free(verdict);
    return answer;
  };
  CHECK(holds() == 0);
  options.within = "1/2";
  CHECK(holds() == 1);
  options.within = "0.499";
  CHECK(holds() == 0);
  const std::vector<double> box = {0, 3, 4, 4};
  diagram.box = box.data();
  CHECK(holds() == 1);
  options.demands = "structure";
  circumspect_verdict* verdict = nullptr;
  CHECK(circumspect_check_voronoi(&diagram, &options, &verdict) == CIRCUMSPECT_INPUT_FAULT);
  diagram.box = nullptr;
  options.within = "1/2";
  std::vector<std::int64_t> ends = {0, -1, 0, -1, 0, -1, 0, -1};
  diagram.ridge_starts = starts.data();
  diagram.ridge_ends = ends.data();
  CHECK(holds() == 1);
  ends[1] = 0;
  CHECK(holds() == 0);
  options.demands = "closed";
  CHECK(circumspect_check_voronoi(&diagram, &options, &verdict) == CIRCUMSPECT_INVALID_ARGUMENT);
  options.demands = nullptr;
  diagram.struct_size = offsetof(circumspect_voronoi, ridge_starts);
  CHECK(holds() == 1);
  diagram.ridge_count = 0;
  CHECK(circumspect_check_voronoi(&diagram, &options, &verdict) == CIRCUMSPECT_INPUT_FAULT);
  diagram.ridge_count = -1;
  CHECK(circumspect_check_voronoi(&diagram, &options, &verdict) == CIRCUMSPECT_INVALID_ARGUMENT);
  diagram.dimension = 4;
  CHECK(circumspect_check_voronoi(&diagram, &options, &verdict) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_check_voronoi(nullptr, &options, &verdict) == CIRCUMSPECT_INVALID_ARGUMENT);
}

TEST_CASE("a mesh that repeats is judged with its lattice and offsets") {
  const std::vector<double> point = {0.25, 0.5}, square = {1, 0, 0, 1}, flat = {1, 2, 2, 4};
  const std::vector<std::int32_t> cells = {0, 0, 0, 0, 0, 0};
  std::vector<std::int64_t> offsets = {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1};
  circumspect_mesh mesh = mesh_of(point, cells);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  const auto judged = [&] { return check("periodic-delaunay", &mesh, nullptr, &options); };
  CHECK(judged().status == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "expected lattice and offsets beside the claim"));
  options.lattice = square.data();
  options.offsets = offsets.data();
  CHECK(circumspect_verdict_holds(judged().verdict.get()) == 1);
  offsets[4] = 0;
  CHECK(circumspect_verdict_holds(judged().verdict.get()) == 0);
  options.lattice = flat.data();
  CHECK(judged().status == CIRCUMSPECT_INPUT_FAULT);
  // The options of an earlier version end before the lattice.
  options.struct_size = offsetof(circumspect_options, lattice);
  CHECK(judged().status == CIRCUMSPECT_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace circumspect::c
