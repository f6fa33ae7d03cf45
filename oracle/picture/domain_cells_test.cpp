// What of the domain a witness names is drawn: a vertex, a segment or a polygon.
#include <algorithm>
#include <sstream>

#include <doctest/doctest.h>

#include "oracle/formats/vtu.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "oracle/model/listed_mesh_test.hpp"
#include "oracle/picture/overview.hpp"
#include "oracle/picture/picture.hpp"

namespace circumspect::picture {
namespace {

using report::Json;

constexpr long kSide = 4;

// Of small cubes, each cut into six tetrahedra.
Mesh mesh_of_cube() {
  const auto arrays = fast::grid_mesh<3>(kSide + 1);
  std::vector<Point> points(arrays.coordinates.size() / 3);
  for (std::size_t i = 0; i < arrays.coordinates.size(); ++i) {
    points[i / 3].push_back(static_cast<long>(arrays.coordinates[i]));
  }
  std::vector<Simplex> simplices(arrays.simplices.size() / 4);
  for (std::size_t i = 0; i < arrays.simplices.size(); ++i) {
    simplices[i / 4].push_back(arrays.simplices[i]);
  }
  return listed_mesh(points, simplices);
}

// Vertex 4x + 2y + z is the corner at those multiples of the side.
Domain cube() {
  PiecewiseLinearInput input;
  for (long v = 0; v < 8; ++v) {
    input.points.push_back({kSide * (v >> 2), kSide * (v >> 1 & 1), kSide * (v & 1)});
  }
  for (const std::vector<Vertex>& square : std::vector<std::vector<Vertex>>{
           {0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
    input.polygons.push_back({{square}, {}});
  }
  return {assemble(input)};
}

Json cell_in_picture(const Witness& witness, const Domain* domain) {
  const Json picture = pictures(std::vector{witness}, mesh_of_cube(), domain).front();
  return picture.contains("cell") ? picture["cell"] : Json();
}

TEST_CASE("picture: a witness's vertex, segment, triangle or polygon of the domain") {
  const Domain domain = cube();
  CHECK(cell_in_picture({.domain_cell = Simplex{5}}, &domain)["vertex"].is_number());
  CHECK(cell_in_picture({.domain_cell = Simplex{0, 1}}, &domain)["segment"].size() == 2);
  const Json triangle = cell_in_picture({.domain_cell = Simplex{0, 1, 3}}, &domain)["polygon"];
  CHECK(triangle["segments"].empty());
  CHECK(triangle["triangles"].size() == 1);
  for (std::size_t p = 0; p < 6; ++p) {
    const Json polygon = cell_in_picture({.polygon = p}, &domain)["polygon"];
    CHECK(polygon["segments"].size() == 4);
    CHECK(polygon["triangles"].size() == 2);
    CHECK(cell_in_picture({.polygon = p}, nullptr).is_null());
  }
}

TEST_CASE("picture: the polygons beside a witness are walls, and its own is not") {
  const Domain domain = cube();
  const auto walls = [&](const Witness& witness) {
    const Json picture = pictures(std::vector{witness}, mesh_of_cube(), &domain).front();
    return picture["walls"]["triangles"].size();
  };
  const Simplex large = {0, 4, 24, 124};  // no polygon is far from it
  CHECK(walls({.simplices = {large}}) == 12);
  CHECK(walls({.simplices = {large}, .polygon = 0}) == 10);
}

TEST_CASE("cells: the vertex, the segment and the triangles of a polygon of the domain") {
  const Domain domain = cube();
  Verdict verdict(Claim::kSteinerTriangulation, 20);
  verdict.add(Rule::kDomainVertexMissing, {.domain_cell = Simplex{5}});
  verdict.add(Rule::kSegmentMissing, {.domain_cell = Simplex{0, 1}});
  verdict.add(Rule::kPolygonNotTiled, {.polygon = 1});
  std::ostringstream out;
  write_cells(out, CellFormat::kVtu, verdict, mesh_of_cube(), &domain);
  const auto file = formats::read_vtu({"cells", out.str()}, NumberReading::kDouble);
  REQUIRE(file);
  const std::vector<Point> points = file->points.points.points();
  CHECK(file->edges.simplices.size() == 1);
  REQUIRE(file->triangles.simplices.size() == 2);
  for (const Simplex& triangle : file->triangles.simplices) {
    for (const Vertex v : triangle) CHECK(points[static_cast<std::size_t>(v)][0] == kSide);
  }
  CHECK(std::count(points.begin(), points.end(), Point{kSide, 0, kSide}) >= 1);
}

TEST_CASE("around a polygon are the simplices at its triangles, around a segment those along it") {
  const Domain domain = cube();
  const Mesh mesh = mesh_of_cube();
  const std::vector<Witness> witnesses = {
      {.polygon = 0}, {.polygon = 3}, {.domain_cell = Simplex{2, 6}}};
  const std::vector<Surroundings> around = surroundings(witnesses, mesh, &domain, 500);
  const auto is_on = [&](const Simplex& simplex, std::size_t axis, long x) {
    return std::any_of(simplex.begin(), simplex.end(),
                       [&](Vertex v) { return mesh.point(v)[axis] == x; });
  };
  REQUIRE(around.size() == 3);
  for (const Surroundings& one : around) CHECK(!one.near.empty());
  for (const Simplex& simplex : around[0].near) CHECK(is_on(simplex, 0, 0));
  for (const Simplex& simplex : around[1].near) CHECK(is_on(simplex, 1, kSide));
  for (const Simplex& simplex : around[2].near) CHECK(is_on(simplex, 2, 0));
}

TEST_CASE("an overview marks what of the domain is missing") {
  const Domain domain = cube();
  const auto place = [&](const Witness& witness) {
    Verdict verdict(Claim::kSteinerTriangulation, 20);
    verdict.add(Rule::kPolygonNotTiled, witness);
    const Json whole = overview(verdict, mesh_of_cube(), &domain, 20);
    REQUIRE(whole["core"] == 1);
    return whole["points"][0].dump();
  };
  CHECK(place({.domain_cell = Simplex{7}}) == "[1.0,1.0,1.0]");
  CHECK(place({.domain_cell = Simplex{0, 1}}) == "[-1.0,-1.0,0.0]");
  const std::string on_polygon = place({.polygon = 1});
  CHECK(on_polygon.starts_with("[1.0,"));
  CHECK(on_polygon.find("1.0,", 4) == on_polygon.npos);  // inside
  CHECK(place({.point = Point{0, 2, 4}, .domain_cell = Simplex{7}}) == "[-1.0,0.0,1.0]");
}

}  // namespace
}  // namespace circumspect::picture
