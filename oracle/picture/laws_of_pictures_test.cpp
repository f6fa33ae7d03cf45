// Laws of pictures: the frame, the ball and the heights fit the points that are drawn, and nothing
// is drawn that is far.
#include <cmath>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "oracle/formats/vtu.hpp"
#include "oracle/model/listed_mesh_test.hpp"
#include "oracle/picture/picture.hpp"

namespace circumspect::picture {
namespace {

using report::Json;
using Spot = std::vector<double>;

double product(const Spot& a, const Spot& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double distance(const Spot& a, const Spot& b) {
  Spot between;
  for (std::size_t i = 0; i < a.size(); ++i) between.push_back(a[i] - b[i]);
  return std::sqrt(product(between, between));
}

// How far points are from the middle, along an axis.
double reach(const Json& picture, const std::set<std::size_t>& places) {
  double most = 0;
  for (const std::size_t place : places) {
    for (const Json& x : picture["points"][place]) most = std::max(most, std::abs(x.get<double>()));
  }
  return most;
}

// The corners of lists of cells.
std::set<std::size_t> corners_of(std::initializer_list<const Json*> lists) {
  std::set<std::size_t> places;
  for (const Json* const cells : lists) {
    for (const Json& cell : *cells) places.insert(cell.begin(), cell.end());
  }
  return places;
}

void check_laws(const Json& picture) {
  constexpr double kFar = 50, kRounding = 1e-6;
  const std::size_t all = picture["points"].size();
  const Json& walls = picture["walls"]["segments"];
  CHECK(reach(picture, corners_of({&picture["near"], &picture["boundary"], &walls})) <= kFar);
  std::set<std::size_t> framed;
  for (std::size_t i = 0; i < picture["core"]; ++i) framed.insert(i);
  if (framed.size() == 1) framed.merge(corners_of({&picture["near"]}));
  CHECK(reach(picture, framed) == doctest::Approx(1));
  const Spot first = picture["points"][0];
  if (picture.contains("ball") && picture["ball"].contains("centre")) {
    const Spot centre = picture["ball"]["centre"], surface = picture["ball"]["surface"];
    const double radius = picture["ball"]["radius"];
    CHECK(distance(centre, surface) == doctest::Approx(radius));
    CHECK(std::abs(distance(first, surface) - std::abs(distance(first, centre) - radius)) <
          kRounding);
  }
  if (!picture.contains("thin")) return;
  const Spot normal = picture["thin"]["normal"];
  CHECK(product(normal, normal) == doctest::Approx(1));
  REQUIRE(picture["thin"]["heights"].size() == all);
  for (std::size_t i = 0; i < all; ++i) {
    const Spot at = picture["points"][i];
    CHECK(std::abs(product(normal, at) - picture["thin"]["heights"][i].get<double>()) < kRounding);
  }
}

}  // namespace

TEST_CASE("in every picture frame, ball and heights fit the points, and nothing is far") {
  const std::vector<Point> plane = {{0, 0}, {7, 1}, {2, 5}, {9, 8}, {3, 2}, {6000, 6000}};
  const std::vector<Simplex> triangles = {{0, 1, 2}, {1, 3, 2}, {1, 5, 3}};
  const std::vector<Point> space = {{0, 0, 0}, {5, 1, 0}, {1, 6, 2}, {2, 1, 7}, {3, 3, -2}};
  const std::vector<Simplex> tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {7, 1}, {2, 5}, {-3000, 4000}, {0, 9}};
  input.segments = {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {2, 4}};
  const Domain domain{assemble(input)};
  for (const Domain* const about : {static_cast<const Domain*>(nullptr), &domain}) {
    // A simplex with its ball; a vertex alone, of which the frame is that of what is around it.
    const std::vector<Witness> witnesses = {
        {.simplices = {{0, 1, 2}}, .vertices = {4}, .ball = circumball(PointSet(plane), {0, 1, 2})},
        {.vertices = {4}, .ball = circumball(PointSet(plane), {0, 1, 2})},
        {.simplices = {{4, 1, 2}}, .ball = circumball(PointSet(plane), {0, 1, 2})},
        {.vertices = {1}},
        {.simplices = {{0, 1, 2}, {1, 3, 2}}, .face = Simplex{1, 2}}};
    for (const Json& picture : pictures(witnesses, listed_mesh(plane, triangles), about)) {
      CAPTURE(picture.dump());
      check_laws(picture);
    }
  }
  const std::vector<Witness> witnesses = {{.simplices = {{0, 1, 2, 3}},
                                           .vertices = {4},
                                           .ball = circumball(PointSet(space), {0, 1, 2, 3})},
                                          {.vertices = {3}},
                                          {.simplices = tetrahedra, .face = Simplex{0, 1, 2}}};
  for (const Json& picture : pictures(witnesses, listed_mesh(space, tetrahedra)))
    check_laws(picture);
}

TEST_CASE("a simplex is around a place only if its box holds the place along every axis") {
  const Mesh mesh = listed_mesh({{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}});
  for (int x = -1; x <= 5; ++x) {
    for (int y = -1; y <= 5; ++y) {
      const std::vector<Witness> witness = {{.point = Point{x, y}}};
      const bool is_in_box = x >= 0 && x <= 4 && y >= 0 && y <= 4;
      CHECK(surroundings(witness, mesh, nullptr, 5)[0].near.empty() != is_in_box);
    }
  }
}

TEST_CASE("a picture says how many simplices around the witness are not drawn") {
  for (const std::size_t count : {8U, 400U, 401U}) {
    std::vector<Point> points = {{0, 0}};
    std::vector<Simplex> fan;
    for (std::size_t i = 0; i <= count; ++i) {
      points.push_back({static_cast<long>(i), static_cast<long>(count)});
      if (i > 0) fan.push_back({0, static_cast<Vertex>(i), static_cast<Vertex>(i + 1)});
    }
    const std::vector<Witness> witness = {{.vertices = {0}}};
    const Json picture = pictures(witness, listed_mesh(points, fan)).front();
    const std::size_t drawn = picture["near"].size();
    CHECK(picture.contains("left_out") == (drawn < count));
    if (count == 8) CHECK(drawn == count);
    if (drawn == count) continue;
    CHECK(picture["left_out"] ==
          std::to_string(count - drawn) + " simplices more around it are not drawn.");
  }
}

TEST_CASE(
    "cells: a repeated vertex makes an edge of a triangle, and a ball without a radius is none") {
  const Mesh mesh = listed_mesh({{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}});
  Verdict verdict(Claim::kWeightedDelaunay, 20);
  verdict.add(Rule::kRepeatedVertex, {.simplices = {{0, 1, 1}}, .ball = Ball{{2, 2}, -1}});
  std::ostringstream out;
  write_cells(out, CellFormat::kVtu, verdict, mesh);
  const auto file = formats::read_vtu({"cells", out.str()}, NumberReading::kDouble);
  REQUIRE(file);
  CHECK(file->edges.simplices == std::vector<Simplex>{{0, 1}});
  CHECK(file->triangles.simplices.empty());
  CHECK(file->points.points.size() == 2);
}

}  // namespace circumspect::picture
