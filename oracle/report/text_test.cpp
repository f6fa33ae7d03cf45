// Verdicts for people, word for word.
#include "oracle/report/text.hpp"

#include <doctest/doctest.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::report {

namespace {

// A kite cut along its longer diagonal, in a file that counts from 1.
ExactMesh kite() {
  return {PointSet({{-2, 0}, {2, 0}, {0, 1}, {0, Rational(-1, 3)}}), {{0, 1, 2}, {3, 1, 0}}, {}, 1};
}

TEST_CASE("verdict line: what holds, with numbers and facts") {
  const ExactMesh square{PointSet({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {{0, 1, 2}, {0, 2, 3}}};
  CHECK(verdict_line(check::judge_points(Claim::kDelaunay, square), in_rows(square), "x.1.ele") ==
        "holds: delaunay x.1.ele 4 points 2 triangles not-unique canonical");
  const ExactMesh other{square.points, {{0, 1, 3}, {1, 2, 3}}};
  CHECK(verdict_line(check::judge_points(Claim::kDelaunay, other), in_rows(other), "x.1.ele") ==
        "holds: delaunay x.1.ele 4 points 2 triangles not-unique not-canonical");
  CHECK(verdict_line(check::judge_points(Claim::kTriangulation, square), in_rows(square), "a b") ==
        "holds: triangulation a b 4 points 2 triangles");
  const ExactMesh none{PointSet({}), {}};
  CHECK(verdict_line(check::judge_points(Claim::kDelaunay, none), in_rows(none), "-") ==
        "holds: delaunay - 0 points 0 simplices unique canonical");
  const ExactMesh point{PointSet({{0, 0, 0}}), {{0}}};
  CHECK(verdict_line(check::judge_points(Claim::kDelaunay, point), in_rows(point), "p") ==
        "holds: delaunay p 1 point 1 vertex unique canonical");
}

TEST_CASE("verdict line: what fails, with the first rule's first witness in the user's indices") {
  const ExactMesh mesh = kite();
  CHECK(verdict_line(check::judge_points(Claim::kDelaunay, mesh), in_rows(mesh), "k.ele") ==
        "fails: delaunay k.ele delaunay.facet-not-local 1 face 1 2 vertex 4");
  CHECK(verdict_line(
            check::judge_exactly(Claim::kDelaunay, mesh, nullptr, {.by = check::By::kDefinition}),
            in_rows(mesh),
            "k.ele") == "fails: delaunay k.ele delaunay.vertex-in-ball 2 simplex 1 2 3 vertex 4");
  ExactMesh broken = kite();
  broken.simplices = {{0, 1, 1}, {0, 1, 77}, {0, 3}};
  CHECK(verdict_line(check::judge_points(Claim::kTriangulation, broken), in_rows(broken), "b") ==
        "fails: triangulation b triangulation.unknown-vertex 1 simplex 1 2 78 vertex 78 also "
        "simplex.wrong-dimension 1 also simplex.repeated-vertex 1 also triangulation.unused-point "
        "1");
  broken.labels = {10, 20, 30, 40};  // after duplicates were merged
  broken.simplices = {{0, 1, 1}};
  CHECK(verdict_line(check::judge_points(Claim::kTriangulation, broken), in_rows(broken), "b") ==
        "fails: triangulation b simplex.repeated-vertex 1 simplex 10 20 20 vertex 20 also "
        "triangulation.unused-point 2");
}

TEST_CASE("verdict line: a rule whose witnesses were all dropped is counted all the same") {
  Verdict verdict(Claim::kTriangulation, kite(), 1);
  verdict.add(Rule::kUnusedPoint, {.vertices = {2}});
  verdict.count(Rule::kOverlap);
  CHECK(verdict_line(verdict, in_rows(kite()), "m") ==
        "fails: triangulation m complex.overlap 1 also triangulation.unused-point 1");
}

TEST_CASE("note: what does not fill its hull may be a mesh of a domain") {
  const ExactMesh dented{PointSet({{-2, 0}, {2, 0}, {0, 3}, {0, 1}}), {{0, 3, 2}, {1, 2, 3}}};
  const auto note = [](const Verdict& verdict, const ExactMesh& mesh) {
    return note_of_domain_not_given(verdict, in_rows(mesh), "m.msh").value_or("none");
  };
  CHECK(note(check::judge_points(Claim::kTriangulation, dented), dented) ==
        "m.msh: a triangulation of points fills their convex hull, and this mesh does not. A mesh "
        "of a domain, which need not be convex, is judged with --domain FILE: what its mesher was "
        "given");
  CHECK(note(check::judge_points(Claim::kWeightedDelaunay, dented), dented) == "none");
  CHECK(note(check::judge_points(Claim::kDelaunay, kite()), kite()) == "none");
  const ExactMesh line{PointSet({{0}, {1}, {2}}), {{0, 1}}};
  CHECK(note(check::judge_points(Claim::kTriangulation, line), line) == "none");
}

TEST_CASE("explanation: nothing of a claim that holds") {
  const ExactMesh mesh = kite();
  CHECK(explanation(check::judge_points(Claim::kTriangulation, mesh), in_rows(mesh)).empty());
}

TEST_CASE("explanation: a facet that is not locally Delaunay, with its ball") {
  const ExactMesh mesh = kite();
  CHECK(explanation(check::judge_points(Claim::kDelaunay, mesh), in_rows(mesh)) ==
        "delaunay.facet-not-local: a facet is not locally Delaunay: the apex on one side lies "
        "strictly inside the circumball on the other\n"
        "  simplex  1 2 3\n"
        "  face     1 2\n"
        "  vertex   4 at (0, -1/3)\n"
        "  ball     centre (0, -1.5) radius ~ 2.5\n"
        "  squared distance from centre: 49/36 ~ 1.3611111111111112\n"
        "  squared radius: 25/4 ~ 6.25\n"
        "  squared radius less squared distance: 44/9 ~ 4.888888888888889\n"
        "delaunay.facet-not-local: worst relative margin 0.7822222222222223\n");
}

// The ball orthogonal to points heavier than it is wide has a negative squared radius.
TEST_CASE("explanation: a ball of heavy points has no radius") {
  const ExactMesh light = kite();
  const ExactMesh heavy{
      PointSet(light.points.points(), {100, 100, 100, 100}), light.simplices, {}, 1};
  const std::string text =
      explanation(check::judge_points(Claim::kWeightedDelaunay, heavy), in_rows(heavy));
  CHECK(text.find("squared radius -375/4") != std::string::npos);
  CHECK(text.find("radius ~") == std::string::npos);
}

TEST_CASE("explanation: an overlap, with a common point; an unused point; what was dropped") {
  const ExactMesh mesh{PointSet({{0, 0}, {2, 0}, {0, 2}, {3, 3}, {9, 9}, {8, 9}}),
                       {{0, 1, 2}, {0, 1, 3}}};
  const std::string unused = "triangulation.unused-point: a point is a vertex of no simplex\n";
  CHECK(explanation(check::judge_points(Claim::kTriangulation, mesh), in_rows(mesh)) ==
        unused + "  vertex   4 at (9, 9)\n  point    (9, 9)\n" + unused +
            "  vertex   5 at (8, 9)\n  point    (8, 9)\n" +
            "complex.overlap: two simplices meet in more than a common face\n"
            "  simplex  0 1 2\n"
            "  simplex  0 1 3\n"
            "  point    (1, 1)\n");
  CHECK(explanation(check::judge_points(Claim::kTriangulation, mesh, {.max_violations = 1}),
                    in_rows(mesh)) == unused + "  vertex   4 at (9, 9)\n  point    (9, 9)\n" +
                                          "… and 2 more (--max-errors 0 shows all)\n");
}

TEST_CASE("explanation: an index without a point has no place; the empty face is named") {
  const ExactMesh unknown{PointSet({{0}, {1}, {2}}), {{0, 1}, {1, 5}}, {}, 1};
  CHECK(explanation(check::judge_points(Claim::kTriangulation, unknown), in_rows(unknown)) ==
        "triangulation.unknown-vertex: a simplex has an index that names no point\n"
        "  simplex  2 6\n"
        "  vertex   6\n"
        "triangulation.unused-point: a point is a vertex of no simplex\n"
        "  vertex   3 at (2)\n  point    (2)\n");
  const ExactMesh gap{PointSet({{0}, {1}, {2}, {3}}), {{0, 1}, {2, 3}}};
  CHECK(explanation(check::judge_points(Claim::kTriangulation, gap), in_rows(gap)) ==
        "triangulation.hull-not-closed: a ridge of the boundary is not shared by exactly two "
        "boundary facets\n"
        "  simplex  0\n"
        "  simplex  1\n"
        "  simplex  2\n"
        "  simplex  3\n"
        "  face     (the empty one)\n");
}

TEST_CASE("explanation: a number too long to read is given by its decimal") {
  Rational long_number(1);
  for (int i = 0; i < 20; ++i) long_number = long_number / 12345 + 1;
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}, {long_number, 5}}), {{0, 1, 2}}};
  const std::string text =
      explanation(check::judge_points(Claim::kTriangulation, mesh), in_rows(mesh));
  CHECK(text.find("  vertex   3 at (~ 1.0000810110174985, 5)") != std::string::npos);
  for (std::size_t line = 0; line < text.size();) {
    const std::size_t end = text.find('\n', line);
    CHECK(end - line < 200);
    line = end + 1;
  }
}

TEST_CASE("claims about a domain: Steiner points, and cells of the domain by its own indices") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 2}}};
  Domain domain{{mesh.points, {{0, 1}}, {}, {}, {}}, {7, 8, 9}};
  Verdict verdict(Claim::kSteinerCdt, mesh, 20);
  verdict.steiner_points = SteinerPoints{2, 0, 1};
  CHECK(verdict_line(verdict, in_rows(mesh), "x.ele", &domain) ==
        "holds: steiner-cdt x.ele 3 points 1 triangle 3 steiner-points 2 on-segments "
        "0 in-polygons 1 in-polyhedra");
  verdict.steiner_points = SteinerPoints{1, 0, 0};
  verdict.dangling = 2;
  CHECK(verdict_line(verdict, in_rows(mesh), "x.ele", &domain) ==
        "holds: steiner-cdt x.ele 3 points 1 triangle 2 dangling 1 steiner-point 1 on-segments "
        "0 in-polygons 0 in-polyhedra");
  verdict.add(Rule::kSegmentMissing, {.face = Simplex{0, 1}, .domain_cell = Simplex{0, 1}});
  verdict.add(Rule::kPolygonNotTiled, {.face = Simplex{0, 1}, .polygon = 2});
  CHECK(verdict_line(verdict, in_rows(mesh), "x.ele", &domain) ==
        "fails: steiner-cdt x.ele domain.segment-missing 1 face 0 1 segment 7 8 also "
        "domain.polygon-not-tiled 1");
  const std::string text = explanation(verdict, in_rows(mesh), &domain);
  CHECK(text.find("  domain   segment 7 8\n") != std::string::npos);
  CHECK(text.find("  domain   polygon 3\n") != std::string::npos);
}

TEST_CASE("wording: simplices by dimension, the two ways by name") {
  CHECK(counted_simplices(0, -1) == "0 simplices");
  CHECK(counted_simplices(0, 0) == "0 vertices");
  CHECK(counted_simplices(2, 1) == "2 edges");
  CHECK(counted_simplices(2, 2) == "2 triangles");
  CHECK(counted_simplices(2, 3) == "2 tetrahedra");
  CHECK(counted_simplices(2, 4) == "2 simplices");
  CHECK(counted_simplices(1, 0) == "1 vertex");
  CHECK(counted_simplices(1, 1) == "1 edge");
  CHECK(counted_simplices(1, 2) == "1 triangle");
  CHECK(counted_simplices(1, 3) == "1 tetrahedron");
  CHECK(counted_simplices(1, 4) == "1 simplex");
  CHECK(counted(0, "point") == "0 points");
  CHECK(counted(1, "point") == "1 point");
  CHECK(counted(1, "polyhedron", "polyhedra") == "1 polyhedron");
  CHECK(counted(3, "polyhedron", "polyhedra") == "3 polyhedra");
  CHECK(name(check::By::kLemma) == "lemma");
  CHECK(name(check::By::kDefinition) == "definition");
}

}  // namespace

TEST_CASE("square roots are rounded up to two digits") {
  CHECK(square_root_rounded_up(0) == "0");
  CHECK(square_root_rounded_up(1) == "1.0e+00");
  CHECK(square_root_rounded_up(2) == "1.5e+00");
  CHECK(square_root_rounded_up(Rational(9801, 100)) == "9.9e+00");
  CHECK(square_root_rounded_up(Rational(9802, 100)) == "1.0e+01");
  CHECK(square_root_rounded_up(100) == "1.0e+01");
  CHECK(square_root_rounded_up(Rational(1, 1'000'000)) == "1.0e-03");
  CHECK(square_root_rounded_up(Rational(1, 999'999)) == "1.1e-03");
}

TEST_CASE("what is printed is no less than the root, and a tenth more at most") {
  Rational squared(7, 3);
  for (int i = 0; i < 60; ++i, squared *= Rational(31, 977)) {
    const auto printed = read_number(square_root_rounded_up(squared), NumberReading::kDecimal);
    REQUIRE(printed);
    CHECK(*printed * *printed >= squared);
    CHECK(*printed * *printed <= squared * Rational(121, 100));
  }
}

// Verdicts for programs: the exact document, and that it suffices to re-check each witness.

namespace {

using check::By;

ExactMesh kite_from_1() {
  return {PointSet({{-2, 0}, {2, 0}, {0, 1}, {0, Rational(-1, 3)}}), {{0, 1, 2}, {3, 1, 0}}, {}, 1};
}

TEST_CASE("json: a claim that holds") {
  const ExactMesh square{PointSet({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {{0, 1, 2}, {0, 2, 3}}};
  CHECK(verdict(check::judge_points(Claim::kDelaunay, square), in_rows(square), "s.ele", By::kLemma)
            .dump() ==
        R"({"mesh":"s.ele","claim":"delaunay","by":"lemma","verdict":"holds","points":4,)"
        R"("simplices":2,"dimension":2,"unique":false,"canonical":true,"rules":[],)"
        R"("violations":[]})");
  const Json triangulation = verdict(check::judge_points(Claim::kTriangulation, square),
                                     in_rows(square), "s.ele", By::kDefinition);
  CHECK(triangulation["claim"] == "triangulation");
  CHECK(triangulation["by"] == "definition");
  CHECK(!triangulation.contains("unique"));
  CHECK(!triangulation.contains("canonical"));
}

TEST_CASE("json: a claim that fails, word for word") {
  const Json document = verdict(check::judge_points(Claim::kDelaunay, kite_from_1()),
                                in_rows(kite_from_1()), "k.ele", By::kLemma);
  CHECK(document.dump() ==
        R"({"mesh":"k.ele","claim":"delaunay","by":"lemma","verdict":"fails","points":4,)"
        R"("simplices":2,"dimension":2,"rules":[{"rule":"delaunay.facet-not-local","count":1,)"
        R"("worst_relative_margin":{"exact":"176/225","decimal":"0.7822222222222223"}}],)"
        R"("violations":[{"rule":"delaunay.facet-not-local","meaning":"a facet is not locally )"
        R"(Delaunay: the apex on one side lies strictly inside the circumball on the other",)"
        R"("simplices":[[1,2,3]],"face":[1,2],"vertices":[4],"ball":{"centre":["0","-3/2"],)"
        R"("squared_radius":{"exact":"25/4","decimal":"6.25"},"radius_decimal":"2.5"},)"
        R"("values":{"squared distance from centre":{"exact":"49/36",)"
        R"("decimal":"1.3611111111111112"},"squared radius":{"exact":"25/4","decimal":"6.25"},)"
        R"("squared radius less squared distance":{"exact":"44/9","decimal":"4.888888888888889"}},)"
        R"("coordinates":{"1":["-2","0"],"2":["2","0"],"3":["0","1"],"4":["0","-1/3"]}}]})");
}

TEST_CASE("json: an orthoball of negative squared radius has no radius") {
  CHECK(ball({{1, Rational(1, 2)}, -3}).dump() ==
        R"({"centre":["1","1/2"],"squared_radius":{"exact":"-3","decimal":"-3"}})");
}

TEST_CASE("json: labels after a merge; an index without a point has no coordinates") {
  ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 9}}, {5, 7, 8}, 5};
  const Json document =
      verdict(check::judge_points(Claim::kTriangulation, mesh), in_rows(mesh), "m", By::kLemma);
  const Json& unknown = document["violations"][0];
  CHECK(unknown["simplices"].dump() == "[[5,7,14]]");
  CHECK(unknown["vertices"].dump() == "[14]");
  CHECK(unknown["coordinates"].dump() == R"({"5":["0","0"],"7":["1","0"]})");
  CHECK(document["violations"][1]["coordinates"].dump() == R"({"8":["0","1"]})");
}

// From here on, only numbers: this is what a user does who trusts the document alone.

Rational exact(const Json& text) {
  return read_number(text.get<std::string>(), NumberReading::kDecimal).value();
}

Point exact_point(const Json& array) {
  Point point;
  for (const Json& text : array) point.push_back(exact(text));
  return point;
}

Point place(const Json& violation, const Json& vertex) {
  return exact_point(violation["coordinates"][std::to_string(vertex.get<long>())]);
}

// Twice the signed area of a triangle.
Rational area(const Point& a, const Point& b, const Point& c) {
  return cross_product(a - c, b - c, 0, 1);
}

bool in_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Rational whole = area(a, b, c);
  return sign(area(p, b, c) * whole) >= 0 && sign(area(a, p, c) * whole) >= 0 &&
         sign(area(a, b, p) * whole) >= 0;
}

void recheck_ball(const Json& violation) {
  const Point centre = exact_point(violation["ball"]["centre"]);
  const Rational squared_radius = exact(violation["ball"]["squared_radius"]["exact"]);
  for (const Json& v : violation["simplices"][0]) {
    CHECK(squared_distance(place(violation, v), centre) == squared_radius);
  }
  const Rational inner = squared_distance(place(violation, violation["vertices"][0]), centre);
  CHECK(inner < squared_radius);
  const Json& values = violation["values"];
  CHECK(exact(values["squared distance from centre"]["exact"]) == inner);
  CHECK(exact(values["squared radius"]["exact"]) == squared_radius);
}

TEST_CASE("json: that a point lies in a ball is re-checked from the document alone") {
  const ExactMesh mesh{
      PointSet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {1, 1, Rational(-1, 7)}}),
      {{0, 1, 2, 3}, {0, 1, 2, 4}},
      {},
      1};
  for (const By by : {By::kLemma, By::kDefinition}) {
    const std::string text =
        verdict(check::judge_exactly(Claim::kDelaunay, mesh, nullptr, {.by = by}), in_rows(mesh),
                "t.ele", by)
            .dump();
    const Json document = Json::parse(text);
    REQUIRE(document["violations"].size() == (by == By::kLemma ? 1U : 2U));
    for (const Json& violation : document["violations"]) recheck_ball(violation);
  }
}

TEST_CASE("json: that a point lies in two triangles is re-checked from the document alone") {
  const ExactMesh mesh{PointSet({{0, 0}, {2, 0}, {0, 2}, {2, 3}}), {{0, 1, 2}, {0, 1, 3}}};
  const Json document = Json::parse(
      verdict(check::judge_points(Claim::kTriangulation, mesh), in_rows(mesh), "o", By::kLemma)
          .dump());
  REQUIRE(document["violations"].size() == 1);
  const Json& violation = document["violations"][0];
  CHECK(violation["rule"] == "complex.overlap");
  const Point common = exact_point(violation["point"]);
  for (const Json& simplex : violation["simplices"]) {
    CHECK(in_triangle(common, place(violation, simplex[0]), place(violation, simplex[1]),
                      place(violation, simplex[2])));
  }
  // Off the common edge from 0 to 1.
  CHECK(sign(area(place(violation, 0), place(violation, 1), common)) != 0);
}

TEST_CASE("json: that a vertex lies beyond a hull facet is re-checked from the document alone") {
  const ExactMesh mesh{PointSet({{0, 0}, {4, 0}, {1, 1}, {0, 4}}), {{0, 1, 2}, {0, 2, 3}}};
  const Json document = Json::parse(
      verdict(check::judge_points(Claim::kTriangulation, mesh), in_rows(mesh), "n", By::kLemma)
          .dump());
  REQUIRE(document["violations"].size() == 1);
  const Json& violation = document["violations"][0];
  const Point a = place(violation, violation["face"][0]);
  const Point b = place(violation, violation["face"][1]);
  Point apex;
  for (const Json& v : violation["simplices"][0]) {
    if (v != violation["face"][0] && v != violation["face"][1]) apex = place(violation, v);
  }
  const Rational own = area(a, b, apex);
  const Rational beyond = area(a, b, place(violation, violation["vertices"][0]));
  CHECK(sign(own) * sign(beyond) == -1);
  const Json& values = violation["values"];
  CHECK(exact(values["orientation determinant of facet and own apex"]["exact"]) == own);
  CHECK(exact(values["orientation determinant of facet and vertex beyond"]["exact"]) == beyond);
}

}  // namespace

}  // namespace circumspect::report
