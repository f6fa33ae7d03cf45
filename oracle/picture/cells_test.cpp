// Witnesses as cells: our own readers find in the files what was written.
#include "oracle/picture/cells.hpp"

#include <sstream>

#include <doctest/doctest.h>
#include <pugixml.hpp>

#include "oracle/formats/gmsh.hpp"
#include "oracle/formats/vtu.hpp"
#include "oracle/judge/points/check.hpp"

namespace circumspect::picture {
namespace {

// A tetrahedron whose ball has vertex 5 inside, which an unused point accompanies.
ExactMesh mesh_with_faults() {
  return {
      PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {Rational(1, 3), Rational(1, 3), -1}}),
      {{0, 1, 2, 3}, {0, 1, 2, 4}},
      {},
      1};
}

Verdict verdict_with_ball(const ExactMesh& mesh) {
  Verdict verdict(Claim::kDelaunay, 20);
  verdict.add(Rule::kVertexInBall, {.simplices = {{0, 1, 2, 3}},
                                    .face = Simplex{0, 1, 2},
                                    .vertices = {4},
                                    .ball = circumball(mesh.points, {0, 1, 2, 3}),
                                    .point = Point{Rational(1, 3), 0, 0}});
  verdict.add(Rule::kUnknownVertex, {.simplices = {{0, 1, 9}}, .vertices = {9}});
  return verdict;
}

std::string written(CellFormat format, const Verdict& verdict, const Mesh& mesh) {
  std::ostringstream out;
  write_cells(out, format, verdict, mesh);
  return out.str();
}

TEST_CASE("cells: both formats are read back") {
  const ExactMesh mesh = mesh_with_faults();
  const Verdict verdict = verdict_with_ball(mesh);
  for (const CellFormat format : {CellFormat::kVtu, CellFormat::kGmsh}) {
    const std::string text = written(format, verdict, in_rows(mesh));
    const formats::Source source{"cells", text};
    const auto file = format == CellFormat::kVtu
                          ? formats::read_vtu(source, NumberReading::kDouble)
                          : formats::read_gmsh(source, NumberReading::kDouble);
    REQUIRE(file);
    CHECK(file->tetrahedra.simplices.size() == 1);
    CHECK(file->triangles.simplices.size() == 1);
    CHECK(file->edges.simplices.size() == 1);  // what is left of the simplex with an unknown vertex
    CHECK(file->points.points.size() == 7);    // five vertices, a point and a centre
    CHECK(file->points.points.back() == Point{Rational(1, 2), Rational(1, 2), Rational(1, 2)});
  }
}

TEST_CASE("cells: each has its rule, its violation and its role; a centre has a radius") {
  const ExactMesh mesh = mesh_with_faults();
  const std::string text = written(CellFormat::kVtu, verdict_with_ball(mesh), in_rows(mesh));
  pugi::xml_document document;
  REQUIRE(document.load_string(text.c_str()));
  const auto piece = document.child("VTKFile").child("UnstructuredGrid").child("Piece");
  const auto array = [&](const char* section, const char* name) {
    std::istringstream in(piece.child(section).find_child_by_attribute("Name", name).text().get());
    std::vector<double> numbers;
    for (double x = 0; in >> x;) numbers.push_back(x);
    return numbers;
  };
  using Numbers = std::vector<double>;
  CHECK(array("CellData", "role") == Numbers{0, 1, 2, 5, 3, 0});
  CHECK(array("CellData", "violation") == Numbers{1, 1, 1, 1, 1, 2});
  CHECK(array("CellData", "rule") == Numbers{23, 23, 23, 23, 23, 1});
  CHECK(rules()[22].rule == Rule::kVertexInBall);
  CHECK(array("PointData", "index") == Numbers{1, 2, 3, 4, 5, -1, -1});
  CHECK(array("PointData", "radius").back() == doctest::Approx(0.8660254037844386));
  CHECK(text.find("<!-- rule 23: delaunay.vertex-in-ball -->") != std::string::npos);
}

TEST_CASE("cells: a verdict that holds gives files without cells") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 2}}};
  const Verdict verdict = check::delaunay(mesh);
  CHECK(written(CellFormat::kVtu, verdict, in_rows(mesh)).find("NumberOfCells=\"0\"") !=
        std::string::npos);
  CHECK(written(CellFormat::kGmsh, verdict, in_rows(mesh)).find("$Elements\n0\n$EndElements") !=
        std::string::npos);
}

}  // namespace
}  // namespace circumspect::picture
