// Verdicts for programs: the document word for word, and that it suffices to re-check each witness.
#include "oracle/report/json.hpp"

#include <doctest/doctest.h>

#include "oracle/judge/points/check.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::report {
namespace {

using check::By;

ExactMesh kite_from_1() {
  return {PointSet({{-2, 0}, {2, 0}, {0, 1}, {0, Rational(-1, 3)}}), {{0, 1, 2}, {3, 1, 0}}, {}, 1};
}

TEST_CASE("json: a claim that holds") {
  const ExactMesh square{PointSet({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {{0, 1, 2}, {0, 2, 3}}};
  CHECK(verdict(check::delaunay(square), in_rows(square), "s.ele", By::kLemma).dump() ==
        R"({"mesh":"s.ele","claim":"delaunay","by":"lemma","verdict":"holds","points":4,)"
        R"("simplices":2,"dimension":2,"unique":false,"canonical":true,"rules":[],)"
        R"("violations":[]})");
  const Json triangulation =
      verdict(check::triangulation(square), in_rows(square), "s.ele", By::kDefinition);
  CHECK(triangulation["claim"] == "triangulation");
  CHECK(triangulation["by"] == "definition");
  CHECK(!triangulation.contains("unique"));
  CHECK(!triangulation.contains("canonical"));
}

TEST_CASE("json: a claim that fails, word for word") {
  const Json document =
      verdict(check::delaunay(kite_from_1()), in_rows(kite_from_1()), "k.ele", By::kLemma);
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
  const Json document = verdict(check::triangulation(mesh), in_rows(mesh), "m", By::kLemma);
  const Json& unknown = document["violations"][0];
  CHECK(unknown["simplices"].dump() == "[[5,7,14]]");
  CHECK(unknown["vertices"].dump() == "[14]");
  CHECK(unknown["coordinates"].dump() == R"({"5":["0","0"],"7":["1","0"]})");
  CHECK(document["violations"][1]["coordinates"].dump() == R"({"8":["0","1"]})");
}

// From here on nothing of ours but numbers: what a user does who trusts the document alone.

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

Rational distance(const Point& a, const Point& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

// Twice the signed area of a triangle.
Rational area(const Point& a, const Point& b, const Point& c) {
  return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
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
    CHECK(distance(place(violation, v), centre) == squared_radius);
  }
  const Rational inner = distance(place(violation, violation["vertices"][0]), centre);
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
        verdict(check::delaunay(mesh, {.by = by}), in_rows(mesh), "t.ele", by).dump();
    const Json document = Json::parse(text);
    REQUIRE(document["violations"].size() == (by == By::kLemma ? 1U : 2U));
    for (const Json& violation : document["violations"]) recheck_ball(violation);
  }
}

TEST_CASE("json: that a point lies in two triangles is re-checked from the document alone") {
  const ExactMesh mesh{PointSet({{0, 0}, {2, 0}, {0, 2}, {2, 3}}), {{0, 1, 2}, {0, 1, 3}}};
  const Json document =
      Json::parse(verdict(check::triangulation(mesh), in_rows(mesh), "o", By::kLemma).dump());
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
  const Json document =
      Json::parse(verdict(check::triangulation(mesh), in_rows(mesh), "n", By::kLemma).dump());
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
