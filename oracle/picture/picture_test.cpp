// Pictures of verdicts, and cells for ParaView and Gmsh.
#include "oracle/picture/picture.hpp"

#include <cmath>
#include <sstream>

#include <doctest/doctest.h>
#include <pugixml.hpp>

#include "kernel/complex/circumball.hpp"
#include "oracle/formats/gmsh.hpp"
#include "oracle/formats/vtu.hpp"
#include "oracle/judge/points/delaunay.hpp"

namespace circumspect::picture {

// What is drawn of a witness: what is near, where it is, and what has no picture.

namespace {

using report::Json;

Rational power_of_ten(int exponent) {
  Rational power = 1;
  for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
  return exponent < 0 ? Rational(1 / power) : power;
}

// Two triangles with the wrong diagonal, of a kite of any size at any place.
ExactMesh kite(const Rational& size = 1, const Point& at = {0, 0}) {
  std::vector<Point> points;
  for (const Point& p : {Point{-2, 0}, {2, 0}, {0, 1}, {0, Rational(-1, 3)}}) {
    points.push_back(at + size * p);
  }
  return {PointSet(points), {{0, 1, 2}, {3, 1, 0}}, {}, 1};
}

Json picture_of(const ExactMesh& mesh) {
  const auto all =
      pictures(check::judge_points(Claim::kDelaunay, mesh), in_rows(mesh), nullptr, 20);
  REQUIRE(all.size() == 1);
  return all.front();
}

TEST_CASE("picture: a face that is one vertex is marked as a vertex is") {
  const ExactMesh bow_tie{PointSet({{0, 0}, {-2, 1}, {-2, -1}, {2, 1}, {2, -1}}),
                          {{0, 1, 2}, {0, 4, 3}}};
  const auto all =
      pictures(check::judge_points(Claim::kTriangulation, bow_tie), in_rows(bow_tie), nullptr, 20);
  REQUIRE(!all.empty());
  CHECK(all[0]["face"].size() == 1);
  CHECK(all[0]["vertices"] == all[0]["face"]);
}

TEST_CASE("picture: the witness first, by the user's indices, and what is around it") {
  const Json picture = picture_of(kite());
  CHECK(picture["dimension"] == 2);
  CHECK(picture["simplices"].dump() == "[[0,1,2]]");
  CHECK(picture["face"].dump() == "[0,1]");
  CHECK(picture["vertices"].dump() == "[3]");
  CHECK(picture["names"].dump() == R"(["1","2","3","4"])");
  CHECK(picture["core"] == 4);
  CHECK(picture["near"].dump() == "[[3,1,0]]");
  CHECK(picture["boundary"].size() == 4);
  CHECK(picture["points"].dump() ==
        "[[-1.0,-0.1666667,0.0],[1.0,-0.1666667,0.0],[0.0,0.3333333,0.0],[0.0,-0.3333333,0.0]]");
  CHECK(picture["ball"]["radius"] == 1.25);
  CHECK(picture["ball"]["centre"].dump().substr(0, 11) == "[0.0,-0.916");
}

TEST_CASE("picture: positions do not depend on size and place, however far beyond doubles") {
  const Json plain = picture_of(kite());
  for (const Rational& size : {power_of_ten(300), power_of_ten(-300), power_of_ten(-1000)}) {
    CHECK(picture_of(kite(size))["points"] == plain["points"]);
    CHECK(picture_of(kite(size, {power_of_ten(900), Rational(1, 3)}))["points"] == plain["points"]);
  }
  CHECK(picture_of(kite(power_of_ten(-1000)))["ball"] == plain["ball"]);
}

TEST_CASE("picture: heights across a thin witness are exact before they are rounded") {
  // A tetrahedron 10^-40 high over an oblique plane: x + y + z = 0.
  const Rational tiny = power_of_ten(-40);
  const ExactMesh mesh{
      PointSet({{1, -1, 0}, {-1, 0, 1}, {0, 1, -1}, {tiny, tiny, tiny}, {2, 2, 2}}),
      {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}}};
  Verdict verdict(Claim::kTriangulation, 20);
  verdict.add(Rule::kOverlap, {.simplices = {{0, 1, 2, 3}}});
  const Json picture = pictures(verdict, in_rows(mesh), nullptr, 20).front();
  const auto heights = picture["thin"]["heights"].get<std::vector<double>>();
  CHECK(heights[0] == heights[1]);
  CHECK(heights[1] == heights[2]);
  CHECK(std::abs(heights[3] - heights[0]) == doctest::Approx(std::sqrt(3) * 1e-40));
  for (const Json& x : picture["thin"]["normal"]) {
    CHECK(std::abs(x.get<double>()) == doctest::Approx(1 / std::sqrt(3)));
  }
}

TEST_CASE("picture: a ball far larger than its simplex has its surface at the simplex") {
  const Rational tiny = power_of_ten(-30);
  const ExactMesh mesh{PointSet({{-1, 0}, {1, 0}, {0, tiny}, {0, -1}}), {{0, 1, 2}, {0, 1, 3}}};
  const Json ball =
      pictures(check::judge_points(Claim::kDelaunay, mesh), in_rows(mesh), nullptr, 20)
          .front()["ball"];
  CHECK(!ball.contains("centre"));
  CHECK(ball["radius"].get<double>() >= 1e12);
  CHECK(std::abs(ball["surface"][0].get<double>()) <= 1);
}

TEST_CASE("picture: what cannot be drawn says why") {
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i) points.push_back({i, i * i, i * i * i, i * i * i * i});
  const ExactMesh four{PointSet(points), {{0, 1, 2, 3, 4}}};
  const auto verdict = check::judge_points(Claim::kTriangulation, four);
  REQUIRE(!verdict.holds());
  CHECK(pictures(verdict, in_rows(four), nullptr, 20).front()["why_none"] ==
        "The points have 4 coordinates, and a picture shows three. The table has all that the "
        "witness "
        "consists of.");
  Verdict empty(Claim::kPlcTriangulation, 20);
  empty.add(Rule::kUncovered, {});
  CHECK(pictures(empty, in_rows(kite()), nullptr, 20).front()["why_none"] ==
        "The witness names no point that could be drawn.");
}

TEST_CASE("picture: an index of no point is not drawn, and no more pictures than wanted are") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 9}}, {5, 7, 8}, 5};
  const Verdict verdict = check::judge_points(Claim::kTriangulation, mesh);
  REQUIRE(verdict.violations().size() == 2);
  const auto all = pictures(verdict, in_rows(mesh), nullptr, 1);
  REQUIRE(all.size() == 1);
  CHECK(all[0]["simplices"].dump() == "[[0,1,null]]");
  CHECK(all[0]["vertices"].dump() == "[null]");
  CHECK(all[0]["names"].dump() == R"(["5","7"])");
}

TEST_CASE(
    "surroundings: those that share most, then those whose box holds a place; the rest is "
    "counted") {
  // A fan of triangles about 0, and one triangle apart.
  ExactMesh mesh{
      PointSet({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {-4, 4}, {-4, 0}, {9, 9}, {9, 10}, {10, 9}}),
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {6, 7, 8}}};
  const std::vector<Witness> witnesses = {{.simplices = {{0, 1, 2}}},
                                          {.point = Point{Rational(19, 2), Rational(19, 2)}}};
  const Mesh rows = in_rows(mesh);
  const auto found = surroundings(witnesses, rows, nullptr, 2);
  CHECK(found[0].near == std::vector<Simplex>{{0, 2, 3}, {0, 3, 4}});
  CHECK(found[0].left_out == 1);
  CHECK(found[1].near == std::vector<Simplex>{{6, 7, 8}});
  CHECK(found[1].left_out == 0);
  CHECK(boundary(rows).size() == 9);
}

// Witnesses as cells: our own readers find in the files what was written.

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
  CHECK(array("PointData", "index") == Numbers{1, 2, 3, 4, 5, -1, -1});
  CHECK(array("PointData", "radius").back() == doctest::Approx(0.8660254037844386));
  CHECK(text.find("<!-- rule 23: delaunay.vertex-in-ball -->") != std::string::npos);
}

TEST_CASE("cells: a verdict that holds gives files without cells") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 2}}};
  const Verdict verdict = check::judge_points(Claim::kDelaunay, mesh);
  CHECK(written(CellFormat::kVtu, verdict, in_rows(mesh)).find("NumberOfCells=\"0\"") !=
        std::string::npos);
  CHECK(written(CellFormat::kGmsh, verdict, in_rows(mesh)).find("$Elements\n0\n$EndElements") !=
        std::string::npos);
}

}  // namespace

}  // namespace circumspect::picture
