// The claim `voronoi`, by lemma and by definition.
#include "oracle/judge/voronoi/judge_voronoi.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <set>

#include <doctest/doctest.h>

#include "oracle/judge/definition/voronoi.hpp"
#include "oracle/judge/voronoi/sites_around.hpp"

namespace circumspect::check {
namespace {

// Four corners of a square and its centre, with unbounded cells as qvoronoi lists them.
VoronoiDiagram square_with_centre() {
  VoronoiDiagram diagram{PointSet(std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}})};
  diagram.vertices = {{2, 0}, {4, 2}, {2, 4}, {0, 2}};
  diagram.cells = {{{0, 3}, true}, {{0, 1}, true}, {{1, 2}, true}, {{2, 3}, true}, {{0, 1, 2, 3}}};
  diagram.neighbors = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  return diagram;
}

// Eight sites at its corners.
VoronoiDiagram cube() {
  std::vector<Point> sites;
  for (int i = 0; i < 8; ++i) sites.push_back({2 * (i & 1), i & 2, (i & 4) / 2});
  VoronoiDiagram diagram{PointSet(sites)};
  diagram.vertices = {{1, 1, 1}};
  diagram.cells.assign(8, {{0}, true});
  for (Vertex a = 0; a < 8; ++a) {
    for (const Vertex bit : {1, 2, 4}) {
      if ((a & bit) == 0) diagram.neighbors.push_back({a, a | bit});
    }
  }
  return diagram;
}

Verdict judged(const VoronoiDiagram& diagram, const Rational& squared_distance = 0,
               const std::optional<JudgedBox>& box = {}) {
  CHECK(fault_of_diagram(diagram, box) == "");
  const Verdict verdict = judge_voronoi(diagram, box, squared_distance, false, 0);
  const Verdict by_definition = judge_voronoi(diagram, box, squared_distance, true, 0);
  CHECK(verdict.holds() == by_definition.holds());
  CHECK(verdict.voronoi->squared_distance == by_definition.voronoi->squared_distance);
  CHECK(verdict.voronoi->site == by_definition.voronoi->site);
  // However few witnesses are kept, each fault is counted.
  const Verdict few = judge_voronoi(diagram, box, squared_distance, false, 1);
  for (const auto& [rule, tally] : verdict.tallies()) {
    CHECK(few.tallies().at(rule).count == tally.count);
  }
  return verdict;
}

TEST_CASE("cells that are exact hold within 0, unbounded ones by their neighbours") {
  const Verdict verdict = judged(square_with_centre());
  CHECK(verdict.holds());
  CHECK(!verdict.voronoi->site);
}

TEST_CASE("the verdict names the least distance, its site and the corner") {
  VoronoiDiagram diagram = square_with_centre();
  diagram.vertices[1] = {5, 2};
  diagram.cells[4].corners = {0, 1, 2, 3};
  const Verdict verdict = judged(diagram);
  CHECK(!verdict.holds());
  CHECK(verdict.voronoi->squared_distance == 1);
  CHECK(judged(diagram, 1).holds());
  CHECK(!judged(diagram, Rational(999, 1000)).holds());
}

TEST_CASE("a cell that lacks a corner is too small, one with another is too large") {
  VoronoiDiagram diagram = square_with_centre();
  diagram.cells[4].corners = {0, 1, 2};
  const Verdict small = judged(diagram);
  REQUIRE(small.violations().size() == 1);
  CHECK(small.violations()[0].witness.vertices == std::vector<Vertex>{4});
  CHECK(*small.violations()[0].witness.point == Point{0, 2});
  CHECK(small.voronoi->squared_distance == 4);
  diagram.vertices.push_back({3, 3});
  diagram.cells[4].corners = {0, 1, 2, 3, 4};
  CHECK(judged(diagram).holds());  // it is in the edge of two others
  diagram.vertices.back() = {4, 4};
  CHECK(judged(diagram).voronoi->squared_distance == 2);
}

TEST_CASE("what is outside of the box is not judged") {
  VoronoiDiagram diagram = square_with_centre();
  diagram.vertices[1] = {5, 2};
  const JudgedBox left{{-1, -1}, {1, 5}};
  CHECK(judged(diagram, 0, left).holds());
  const JudgedBox beside{{9, 9}, {10, 10}};
  CHECK(judged(square_with_centre(), 0, beside).holds());
}

TEST_CASE("a cell that is empty is missing, an index of no vertex is named") {
  VoronoiDiagram diagram = square_with_centre();
  diagram.cells[4].corners = {};
  CHECK(judged(diagram).tallies().begin()->first == Rule::kCellMissing);
  for (const Vertex none : {-1, 4, 7}) {
    diagram.cells[4].corners = {0, 1, none};
    CHECK(judged(diagram).tallies().begin()->first == Rule::kVoronoiUnknownVertex);
  }
}

TEST_CASE("one site, and two, have cells like all others") {
  VoronoiDiagram one{PointSet(std::vector<Point>{{3, 3}})};
  one.vertices = {{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  one.cells = {{{0, 1, 2, 3}}};
  CHECK(judged(one).holds());  // the default box is that
  VoronoiDiagram two{PointSet(std::vector<Point>{{0, 0}, {2, 0}})};
  two.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {3, -1}, {3, 1}};
  two.cells = {{{0, 1, 2, 3}}, {{1, 4, 5, 2}}};
  CHECK(judged(two).holds());
}

TEST_CASE("cells in space: eight sites at the corners of a cube") {
  VoronoiDiagram diagram = cube();
  CHECK(judged(diagram).holds());
  diagram.vertices = {{1, 1, Rational(5, 4)}};
  CHECK(judged(diagram).voronoi->squared_distance == Rational(1, 16));
}

TEST_CASE("ridges that are not listed do not make unbounded cells larger") {
  VoronoiDiagram diagram = cube();
  diagram.neighbors = {{0, 1}};  // of twelve
  CHECK(judged(diagram).holds());
}

TEST_CASE("where the sites are does not matter: shifted, in a mirror, turned, twice as large") {
  const auto shifted = [](long by) {
    return [by](Point point) {
      for (Rational& x : point) x += by;
      return point;
    };
  };
  const auto mirrored = [](Point point) {
    point[0] = -point[0];
    return point;
  };
  const auto turned = [](Point point) {
    std::swap(point[0], point[1]);
    point[0] = -point[0];
    return point;
  };
  const auto doubled = [](const Point& point) { return Rational(2) * point; };
  const std::vector<std::pair<std::function<Point(Point)>, long>> maps = {
      {shifted(-100), 1}, {shifted(100), 1}, {mirrored, 1}, {turned, 1}, {doubled, 4}};
  for (VoronoiDiagram diagram : {square_with_centre(), cube()}) {
    for (const bool is_wrong : {false, true}) {
      if (is_wrong) diagram.vertices.back()[1] += Rational(1, 4);
      const Verdict verdict = judged(diagram);
      CHECK(verdict.holds() != is_wrong);
      for (const auto& [map, scale] : maps) {
        std::vector<Point> sites = diagram.sites.points();
        for (Point& site : sites) site = map(site);
        VoronoiDiagram moved{PointSet(sites), diagram.vertices, diagram.cells, diagram.neighbors};
        for (Point& vertex : moved.vertices) vertex = map(vertex);
        const Verdict again = judged(moved);
        CHECK(again.voronoi->squared_distance == scale * verdict.voronoi->squared_distance);
        CHECK(again.violations().size() == verdict.violations().size());
      }
    }
  }
}

TEST_CASE("what cannot be judged is refused, with what to do") {
  VoronoiDiagram diagram = square_with_centre();
  diagram.neighbors.clear();
  CHECK(fault_of_diagram(diagram, {}) ==
        "expected the pairs of sites that have a common ridge beside unbounded cells, found none: "
        "run qvoronoi with both o and Fv");
  diagram.cells.pop_back();
  CHECK(fault_of_diagram(diagram, {}) == "expected a cell for each of 5 sites, found 4 cells");
  for (const Vertex none : {-1, 5}) {
    for (const auto& ridge : {std::array{none, Vertex{0}}, std::array{Vertex{4}, none}}) {
      diagram = square_with_centre();
      diagram.neighbors.push_back({ridge[0], ridge[1]});
      CHECK(fault_of_diagram(diagram, {}) ==
            "expected ridges between sites, found one of site " + std::to_string(none));
    }
  }
  diagram = square_with_centre();
  diagram.vertices.push_back({1, 2, 3});
  CHECK(fault_of_diagram(diagram, {}) ==
        "expected vertices of dimension 2, as the sites, found another");
  diagram.sites = PointSet(std::vector<Point>{{0}, {1}});
  CHECK(fault_of_diagram(diagram, {}) ==
        "expected sites in the plane or in space for the claim voronoi, found dimension 1");
  diagram = square_with_centre();
  const auto of_box = [&](const Point& low, const Point& high) {
    return fault_of_diagram(diagram, JudgedBox{low, high});
  };
  CHECK(of_box({0, 0}, {1, 1}) == "");
  for (const auto& fault : {of_box({0, 0}, {1, 0}), of_box({0, 1}, {1, 0}), of_box({1, 0}, {0, 1}),
                            of_box({0, 0, 0}, {1, 1, 1})}) {
    CHECK(
        fault ==
        "expected a box with 4 numbers, the least and then the larger coordinates, found another");
  }
}

TEST_CASE("a cell that is listed where the site has none is too large") {
  VoronoiDiagram diagram = square_with_centre();
  const JudgedBox corner{{5, 5}, {6, 6}};  // of the third site alone
  CHECK(judged(diagram, 0, corner).holds());
  diagram.vertices.push_back({6, 6});
  diagram.cells[4].corners.push_back(4);
  const Verdict verdict = judged(diagram, 100, corner);
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].rule == Rule::kCellDiffers);
  CHECK(verdict.violations()[0].witness.vertices == std::vector<Vertex>{4});
}

TEST_CASE("cells are those of all sites, however these are spread") {
  std::mt19937 random(1);
  const auto below = [&](unsigned count) { return static_cast<long>(random() % count); };
  for (int round = 0; round < 6; ++round) {
    // Two crowds far from each other, and some sites between them.
    std::set<Point> sites;
    while (sites.size() < 14) {
      const long away = below(3) == 0 ? 10 + below(20) : below(2) * 60;
      sites.insert({away + below(4), below(4) + (away > 5 ? below(30) : 0)});
    }
    const PointSet set({sites.begin(), sites.end()});
    const JudgedBox box = default_box(set);
    const SitesAround around(set, box);
    for (Vertex site = 0; set.names(site); ++site) {
      CAPTURE(site);
      std::vector<Point> expected = definition::exact_corners(set, site, box);
      std::sort(expected.begin(), expected.end());
      CHECK(around.corners_of_cell(site) == expected);
    }
  }
}

}  // namespace
}  // namespace circumspect::check
