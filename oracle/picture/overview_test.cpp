// The picture of a whole mesh: where its violations are, and that it stays small.
#include "oracle/picture/overview.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "oracle/judge/points/delaunay.hpp"
#include "oracle/picture/picture.hpp"

namespace circumspect::picture {
namespace {

using report::Json;

// A square grid of so many cells a side, each cut into two triangles.
ExactMesh grid(long side) {
  std::vector<Point> points;
  std::vector<Simplex> triangles;
  for (long y = 0; y <= side; ++y) {
    for (long x = 0; x <= side; ++x) points.push_back({x, y});
  }
  for (long y = 0; y < side; ++y) {
    for (long x = 0; x < side; ++x) {
      const Vertex corner = y * (side + 1) + x;
      triangles.push_back({corner, corner + 1, corner + side + 2});
      triangles.push_back({corner, corner + side + 2, corner + side + 1});
    }
  }
  return {PointSet(points), triangles, {}, 1};
}

Json overview_of(const ExactMesh& mesh, std::size_t shown = 20) {
  return overview(check::judge_points(Claim::kTriangulation, mesh), in_rows(mesh), nullptr, shown);
}

TEST_CASE("an overview marks the place of a violation, in the frame of the mesh") {
  ExactMesh mesh = grid(10);
  std::swap(mesh.simplices.front(), mesh.simplices.back());
  mesh.simplices.front() =
      mesh.simplices[1];  // the triangle at (10, 10) is gone, the one at (0, 0) is there twice
  const Json whole = overview_of(mesh);
  REQUIRE(whole["core"] == 1);
  CHECK(whole["mark"] == "whole");
  CHECK(whole["dimension"] == 2);
  CHECK(whole["marks"].dump() == "[[0]]");
  const Json& place = whole["points"][0];  // the middle of (0, 0), (1, 1), (0, 1)
  CHECK(place.dump() == "[-0.9333,-0.8667,0.0]");
  CHECK(whole["skin"].size() == 200);
  CHECK(whole["coarser"] == false);
}

TEST_CASE("violations that are near each other share a mark; others have their own") {
  ExactMesh mesh = grid(40);
  mesh.simplices.push_back(mesh.simplices[0]);
  mesh.simplices.push_back(mesh.simplices[1]);
  mesh.simplices.push_back(mesh.simplices.at(3199));
  const Json whole = overview_of(mesh);
  CHECK(whole["marks"].dump() == "[[0,1],[2]]");
  CHECK(overview_of(mesh, 1)["marks"].dump() == "[[0]]");
}

TEST_CASE("a skin of too many triangles is drawn with fewer, which keep its extent") {
  const Json whole = overview_of(grid(60));
  CHECK(whole["coarser"] == true);
  CHECK(whole["skin"].size() <= 2500);
  CHECK(whole["skin"].size() > 300);
  for (const char* coordinate : {"-1.0", "1.0"}) {
    CHECK(whole["points"].dump().find(coordinate) != std::string::npos);
  }
  for (const Json& triangle : whole["skin"]) {
    CHECK(triangle[0] != triangle[1]);
    CHECK(triangle[1] != triangle[2]);
    CHECK(triangle[0] != triangle[2]);
  }
}

TEST_CASE(
    "what the picture of a witness shows whole has no overview, nor what no picture can show") {
  CHECK(overview_of(grid(5)).is_null());
  std::vector<Point> line;
  std::vector<Simplex> edges;
  for (long x = 0; x < 100; ++x) line.push_back({x});
  for (Vertex v = 0; v + 1 < 100; ++v) edges.push_back({v, v + 1});
  CHECK(overview_of({PointSet(line), edges}).is_null());
  ExactMesh beyond = grid(10);
  std::vector<Point> points = beyond.points.points();
  Rational huge = 1;
  for (int i = 0; i < 400; ++i) huge *= 10;
  for (Point& point : points) point[0] *= huge;
  beyond.points = PointSet(points);
  CHECK(overview_of(beyond).is_null());
}

TEST_CASE("the skin of tetrahedra is their boundary, in one pass over the mesh or in many") {
  // Two tetrahedra on a common triangle.
  const ExactMesh mesh{PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}),
                       {{0, 1, 2, 3}, {4, 3, 2, 1}}};
  std::vector<Simplex> once = boundary(in_rows(mesh));
  CHECK(once.size() == 6);
  CHECK(std::count(once.begin(), once.end(), Simplex{1, 2, 3}) == 0);
  std::vector<Simplex> often = boundary(in_rows(mesh), 2);
  std::sort(often.begin(), often.end());
  CHECK(often == once);
}

}  // namespace
}  // namespace circumspect::picture
