// What is required of simplices: equal to the bound is enough, and what is set apart is not
// measured.
#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/judge/quality/judge_quality.hpp"
#include "oracle/model/listed_mesh_test.hpp"

namespace circumspect::check {
namespace {

const std::vector<Point> kHouse = {{0, 0}, {10, 0}, {10, 8}, {0, 8}, {5, 1}};
const std::vector<Simplex> kRoofs = {{0, 1, 4}, {3, 0, 4}, {1, 2, 4}, {2, 3, 4}};

Options requiring(std::initializer_list<const char*> texts, By by = By::kLemma) {
  Options options{.by = by, .max_violations = 0, .threads = 1};
  for (const char* text : texts) {
    options.quality.requirements.push_back(read_requirement(text).value());
  }
  return options;
}

// How many simplices do not keep the requirement; the same in both ways.
std::size_t broken(const Mesh& mesh, const char* text) {
  std::size_t counts[2];
  for (const By by : {By::kLemma, By::kDefinition}) {
    Verdict verdict(Claim::kComplex, 0);
    judge_quality(mesh, nullptr, 0, requiring({text}, by), verdict);
    std::size_t& count = counts[by == By::kLemma ? 0 : 1];
    count = 0;
    for (const auto& [rule, tally] : verdict.tallies()) {
      CHECK(rule == entry(read_requirement(text)->measure).rule);
      count += tally.count;
    }
    CHECK(verdict.violations().size() == count);
  }
  CHECK(counts[0] == counts[1]);
  return counts[0];
}

TEST_CASE("a simplex that measures as much as the bound keeps it, and no less") {
  const Mesh house = listed_mesh(kHouse, kRoofs);
  CHECK(broken(house, "edge:10") == 0);
  CHECK(broken(house, "edge:9.999999999999999999") == 2);
  CHECK(broken(house, "min-edge:sqrt(26)") == 0);
  CHECK(broken(house, "min-edge:sqrt(26.00000000000000000001)") == 3);
  CHECK(broken(house, "area:35") == 0);
  CHECK(broken(house, "area:34.9999999999999999999") == 1);
  CHECK(broken(house, "radius-edge:sqrt(13/2)") == 0);
  CHECK(broken(house, "radius-edge:sqrt(6.49999999999999999999)") == 1);
  CHECK(broken(house, "aspect-ratio:10") == 0);
  CHECK(broken(house, "aspect-ratio:9.99999999999999999999") == 1);
  const Mesh halves = listed_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK(broken(halves, "min-angle:45deg") == 0);
  CHECK(broken(halves, "min-angle:45.00000000000000000001deg") == 2);
  CHECK(broken(halves, "max-angle:90deg") == 0);
  CHECK(broken(halves, "max-angle:89.99999999999999999999deg") == 2);
  const Mesh corner = listed_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  CHECK(broken(corner, "max-dihedral:90deg") == 0);
  CHECK(broken(corner, "max-dihedral:89.99999999999999999999deg") == 1);
  CHECK(broken(corner, "min-dihedral:54.7356deg") == 0);  // arccos(1/√3)
  CHECK(broken(corner, "min-dihedral:54.7357deg") == 1);
  CHECK(broken(corner, "volume:1/6") == 0);
  CHECK(broken(corner, "volume:0.166666") == 1);
  CHECK(broken(corner, "radius-edge:sqrt(3/4)") == 0);
  CHECK(broken(corner, "aspect-ratio:sqrt(6)") == 0);  // √2 over 1/√3
  CHECK(broken(corner, "aspect-ratio:sqrt(5.999)") == 1);
}

TEST_CASE("the witness is the simplex, the corner or the edge, and the exact value") {
  Verdict verdict(Claim::kComplex, 0);
  judge_quality(listed_mesh(kHouse, kRoofs), nullptr, 0,
                requiring({"min-angle:20deg", "edge:9", "radius-edge:2"}), verdict);
  REQUIRE(verdict.violations().size() == 4);
  const Witness& angle = verdict.violations()[0].witness;
  CHECK(angle.simplices == std::vector<Simplex>{{0, 1, 4}});
  CHECK(angle.vertices == std::vector<Vertex>{0});
  CHECK(!angle.face);
  CHECK(angle.measured->value == Rational(25, 26));
  CHECK(angle.measured->required == "min-angle >= 20deg");
  const Witness& edge = verdict.violations()[1].witness;
  CHECK(edge.face == Simplex{0, 1});
  CHECK(edge.measured->value == 100);
  CHECK(verdict.violations()[3].witness.measured->value == Rational(13, 2));
  CHECK(verdict.quality->required ==
        std::vector<std::string>{"min-angle:20deg", "edge:9", "radius-edge:2"});
}

TEST_CASE("what is set apart is not measured") {
  const Mesh mesh = listed_mesh(kHouse, {{0, 1, 4}, {0, 1, 9}, {0, 1, 1}, {0, 1, -1}});
  CHECK(broken(mesh, "edge:9") == 1);
  CHECK(broken(listed_mesh({{0, 0}, {1, 1}, {2, 2}, {5, 0}}, {{0, 1, 2}, {0, 1, 3}}),
               "min-angle:59deg") == 1);
  CHECK(broken(listed_mesh(kHouse, {{0, 1, 4}, {0, 1}}), "edge:9") == 1);
  const Mesh in_thirds = listed_mesh({{Rational(1, 3), 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  CHECK(broken(in_thirds, "min-edge:2/3") == 0);
  CHECK(broken(in_thirds, "min-edge:0.6667") == 1);
}

TEST_CASE("doubles that overflow or underflow in the filter are decided exactly") {
  for (const double scale : {0x1p-1060, 0x1p-600, 0x1p-300, 0x1p300, 0x1p1000}) {
    const Rational unit = exact_value(scale);
    std::vector<Point> points;
    for (const Point& corner : std::vector<Point>{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}) {
      points.push_back(unit * corner);
    }
    const Mesh mesh = listed_mesh(points, {{0, 1, 2, 3}});
    CAPTURE(scale);
    CHECK(broken(mesh, "max-dihedral:89deg") == 1);
    CHECK(broken(mesh, "max-dihedral:91deg") == 0);
    CHECK(broken(mesh, "radius-edge:0.8") == 1);
    CHECK(broken(mesh, "radius-edge:0.9") == 0);
    CHECK(broken(mesh, "min-angle:46deg") == 1);
    CHECK(broken(mesh, "min-angle:44deg") == 0);
    CHECK(broken(mesh, "volume:1") == (scale > 1 ? 1 : 0));
    CHECK(broken(mesh, "min-edge:1") == (scale > 1 ? 0 : 1));
  }
}

// Three rooms beside each other, with a wall after 3 and one after 5; the one in the middle has no
// bound.
Domain three_rooms(const Rational& most_left, const Rational& most_right) {
  PiecewiseLinearInput input;
  for (const long x : {0, 3, 5, 9}) {
    for (const long y : {0, 4}) input.points.push_back({x, y});
  }
  input.segments = {{0, 1}, {2, 3}, {4, 5}, {6, 7}};
  for (Vertex v = 0; v < 6; ++v) input.segments.push_back({v, v + 2});
  Domain rooms{assemble(input)};
  rooms.region_bounds = {{{1, 1}, most_left}, {{6, 1}, most_right}, {{2, 3}, most_left}};
  return rooms;
}

TEST_CASE("each region has its bound, in whatever order its triangles are listed") {
  generators::Dice dice(46);
  const Domain rooms = three_rooms(Rational(3, 2), 2);
  std::vector<Point> points;
  std::vector<Simplex> triangles;
  std::size_t expected = 0;
  for (int i = 0; i < 200; ++i) {
    const std::size_t room = dice.below(3);
    const long low[] = {0, 3, 5}, high[] = {3, 5, 9};
    Simplex& triangle = triangles.emplace_back();
    for (int corner = 0; corner < 3; ++corner) {
      triangle.push_back(static_cast<Vertex>(points.size()));
      points.push_back({dice.within(low[room], high[room]), dice.within(0L, 4L)});
    }
    const Point &a = points.end()[-3], &b = points.end()[-2], &c = points.end()[-1];
    const Rational twice = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    if (room == 0) expected += twice > 3 ? 1 : 0;
    if (room == 2) expected += twice > 4 ? 1 : 0;
  }
  const Mesh mesh = listed_mesh(points, triangles);
  CHECK(expected > 30);
  for (const By by : {By::kLemma, By::kDefinition}) {
    Verdict verdict(Claim::kComplex, 0);
    judge_quality(mesh, &rooms, 0, requiring({"area:regions"}, by), verdict);
    CHECK(verdict.tallies().at(entry(Measure::kArea).rule).count == expected);
  }
}

TEST_CASE("bounds of regions are refused where they bound nothing, or twice") {
  const Mesh mesh = listed_mesh(kHouse, kRoofs);
  const auto fault = [&](const Domain* domain, bool is_moved = false) {
    return fault_of_quality(mesh, requiring({"area:regions"}).quality, domain, is_moved);
  };
  Domain rooms = three_rooms(1, 2);
  CHECK(fault(&rooms).empty());
  const Mesh corner = listed_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  CHECK(fault_of_quality(corner, requiring({"area:regions"}).quality, &rooms, false)
            .find("in dimension 3") != std::string::npos);
  // Even of a single point, and not of none.
  CHECK(fault_of_quality(listed_mesh({{1, 1, 1}}, {}), requiring({"area:regions"}).quality, &rooms,
                         false)
            .find("in dimension 3") != std::string::npos);
  CHECK(fault_of_quality(Mesh(), requiring({"area:regions"}).quality, &rooms, false).empty());
  CHECK(fault(&rooms, true).find("found a distance") != std::string::npos);
  CHECK(fault(nullptr).find("found no domain") != std::string::npos);
  rooms.region_bounds.push_back({{8, 3}, 3});
  CHECK(fault(&rooms).find("found 2 at (6, 1) and 3 at (8, 3)") != std::string::npos);
  rooms.region_bounds = {{{3, 2}, 1}};
  CHECK(fault(&rooms).find("which is on a segment") != std::string::npos);
  rooms.region_bounds.clear();
  CHECK(fault(&rooms).find("found none in it") != std::string::npos);
}

}  // namespace
}  // namespace circumspect::check
