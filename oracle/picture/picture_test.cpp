// What is drawn of a witness: what is near, where it is, and what has no picture.
#include "oracle/picture/picture.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "oracle/judge/points/check.hpp"
#include "oracle/picture/surroundings.hpp"

namespace circumspect::picture {
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
  const auto all = pictures(check::delaunay(mesh), in_rows(mesh), nullptr, 20);
  REQUIRE(all.size() == 1);
  return all.front();
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
  const Json ball = pictures(check::delaunay(mesh), in_rows(mesh), nullptr, 20).front()["ball"];
  CHECK(!ball.contains("centre"));
  CHECK(ball["radius"].get<double>() >= 1e12);
  CHECK(std::abs(ball["surface"][0].get<double>()) <= 1);
}

TEST_CASE("picture: what cannot be drawn says why") {
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i) points.push_back({i, i * i, i * i * i, i * i * i * i});
  const ExactMesh four{PointSet(points), {{0, 1, 2, 3, 4}}};
  const auto verdict = check::triangulation(four);
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
  const Verdict verdict = check::triangulation(mesh);
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
  const std::vector<Violation> violations = {
      {Rule::kOverlap, {.simplices = {{0, 1, 2}}}},
      {Rule::kUncovered, {.point = Point{Rational(19, 2), Rational(19, 2)}}}};
  const Mesh rows = in_rows(mesh);
  const auto found = surroundings(violations, rows, nullptr, 2);
  CHECK(found[0].near == std::vector<Simplex>{{0, 2, 3}, {0, 3, 4}});
  CHECK(found[0].left_out == 1);
  CHECK(found[1].near == std::vector<Simplex>{{6, 7, 8}});
  CHECK(found[1].left_out == 0);
  CHECK(boundary(rows).size() == 9);
}

}  // namespace
}  // namespace circumspect::picture
