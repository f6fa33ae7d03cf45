// The vertices and ridges of a Voronoi diagram: what is joined, what is outside, what may be left
// out.
#include "oracle/judge/voronoi/judge_structure.hpp"

#include <map>

#include <doctest/doctest.h>

#include "oracle/judge/voronoi/judge_voronoi.hpp"

namespace circumspect::check {
namespace {

using Broken = std::map<Rule, std::size_t>;

// What is wrong with the vertices and the ridges, by definition and by lemma.
Broken broken(const VoronoiDiagram& diagram, const Rational& squared_distance = 0,
              const std::optional<JudgedBox>& box = {}) {
  CHECK(fault_of_structure(diagram) == "");
  std::map<bool, Broken> found;
  for (const bool by_definition : {false, true}) {
    const Verdict verdict = judge_voronoi(diagram, box, squared_distance, by_definition, 0, true);
    for (const auto& [rule, tally] : verdict.tallies()) {
      const bool is_of_cells = rule == Rule::kCellDiffers || rule == Rule::kCellMissing;
      if (!is_of_cells) found[by_definition][rule] = tally.count;
    }
  }
  CHECK(found[false] == found[true]);
  return found[false];
}

// Four corners of a square and its centre: four vertices, and eight ridges, four of which leave the
// box of corners (-2, -2) and (6, 6).
VoronoiDiagram square_with_ridges() {
  VoronoiDiagram diagram{PointSet(std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}})};
  diagram.vertices = {{2, 0}, {4, 2}, {2, 4}, {0, 2}};
  diagram.cells = {{{0, 3}, true}, {{0, 1}, true}, {{1, 2}, true}, {{2, 3}, true}, {{0, 1, 2, 3}}};
  diagram.neighbors = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 1}, {2, 4}, {3, 4}};
  diagram.ridges = {{{0}, true}, {{1}, true}, {{2}, true}, {{3}, true},
                    {{3, 0}},    {{0, 1}},    {{1, 2}},    {{2, 3}}};
  return diagram;
}

TEST_CASE("structure: each ridge with both ends, in the plane, and nothing else") {
  CHECK(broken(square_with_ridges()).empty());
  for (std::size_t r = 0; r < 8; ++r) {
    CAPTURE(r);
    const auto at = static_cast<std::ptrdiff_t>(r);
    VoronoiDiagram missing = square_with_ridges();
    missing.ridges.erase(missing.ridges.begin() + at);
    missing.neighbors.erase(missing.neighbors.begin() + at);
    CHECK(broken(missing) == Broken{{Rule::kRidgeMissing, 1}});
    VoronoiDiagram differs = square_with_ridges();
    differs.ridges[r].corners[0] = (differs.ridges[r].corners[0] + 2) % 4;
    CHECK(broken(differs) == Broken{{Rule::kRidgeDiffers, 1}});
    VoronoiDiagram open = square_with_ridges();
    open.ridges[r].is_unbounded = !open.ridges[r].is_unbounded;
    CHECK(broken(open) == Broken{{Rule::kRidgeDiffers, 1}});
    VoronoiDiagram unknown = square_with_ridges();
    unknown.ridges[r].corners.push_back(4);
    CHECK(broken(unknown) == Broken{{Rule::kVoronoiUnknownVertex, 1}});
  }
  VoronoiDiagram across = square_with_ridges();
  across.neighbors.push_back({0, 2});  // cells that have no common ridge
  across.ridges.push_back({{0, 2}});
  CHECK(broken(across) == Broken{{Rule::kRidgeDiffers, 1}});
  across.ridges.back() = {{0}};  // it has no length
  CHECK(broken(across).empty());
}

TEST_CASE(
    "structure: vertices within the distance are one, of either kind, and one of each is there") {
  VoronoiDiagram diagram = square_with_ridges();
  diagram.vertices.push_back({2, 0});
  diagram.ridges[4].corners[1] = 4;
  CHECK(broken(diagram).empty());
  const Rational tenth(1, 10);
  diagram.vertices[0][0] += tenth;
  CHECK(broken(diagram) == Broken{{Rule::kVertexUnmatched, 1}});
  CHECK(broken(diagram, tenth * tenth).empty());
  diagram.vertices[4][0] += 2 * tenth;  // near the other listed one alone
  CHECK(broken(diagram, tenth * tenth).empty());
  CHECK(broken(diagram, tenth * tenth / 2) == Broken{{Rule::kVertexUnmatched, 3}});
}

TEST_CASE(
    "structure: what is outside of the box, or not deeper in it than the distance, is one end") {
  VoronoiDiagram diagram = square_with_ridges();
  const JudgedBox box{{Rational(1, 2), -1}, {6, 6}};  // without (0, 2)
  CHECK(broken(diagram, 0, box).empty());
  diagram.vertices[3] = {0, 1};
  CHECK(broken(diagram, 0, box).empty());
  diagram.vertices[3] = {1, 2};
  CHECK(broken(diagram, 0, box) == Broken{{Rule::kVertexUnmatched, 1}});
  CHECK(broken(diagram, Rational(1, 4), box).empty());
  CHECK(broken(diagram, 1, JudgedBox{{0, -1}, {6, 6}}).empty());
  CHECK(broken(diagram, 1, JudgedBox{{-2, -1}, {6, 6}}).empty());  // within reach of each other
  diagram.ridges[4].is_unbounded = true;  // (0, 2) and outside are one end now
  diagram.ridges[4].corners = {0};
  CHECK(broken(diagram, 0, JudgedBox{{Rational(3, 2), -1}, {6, 6}}).empty());
  CHECK(broken(diagram, 1, JudgedBox{{-2, -1}, {6, 6}}) == Broken{{Rule::kRidgeDiffers, 1}});
}

// Eight sites at the corners of a cube, and twelve wedges around its centre.
TEST_CASE(
    "structure: in space ridges with two ends may be left out, or join others of the corners") {
  std::vector<Point> sites;
  for (int i = 0; i < 8; ++i) sites.push_back({2 * (i & 1), i & 2, (i & 4) / 2});
  VoronoiDiagram diagram{PointSet(sites)};
  diagram.vertices = {{1, 1, 1}};
  diagram.cells.assign(8, {{0}, true});
  diagram.neighbors = {{0, 1}};
  diagram.ridges = {{{0}, true}};
  CHECK(broken(diagram).empty());
  diagram.neighbors = {{0, 7}};
  CHECK(broken(diagram).empty());
  diagram.vertices.push_back({1, 1, 2});
  diagram.ridges = {{{0, 1}}};
  CHECK(broken(diagram) == Broken{{Rule::kVertexUnmatched, 1}});
}

// A cube with sites at its centre and beyond its faces: the cell of the centre has six squares.
TEST_CASE("structure: in space a ridge with three ends or more is listed with them") {
  std::vector<Point> sites = {{0, 0, 0}};
  VoronoiDiagram diagram{PointSet(std::vector<Point>{})};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-2, 2}) {
      sites.push_back({0, 0, 0});
      sites.back()[axis] = side;
    }
  }
  diagram.sites = PointSet(sites);
  for (Vertex v = 0; v < 8; ++v) {
    diagram.vertices.push_back({v % 2 * 2 - 1, v / 2 % 2 * 2 - 1, v / 4 * 2 - 1});
  }
  diagram.cells.assign(7, {});
  diagram.cells[0].corners = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto add = [&](Vertex site, Vertex other) {
    ListedCell ridge;
    for (Vertex v = 0; v < 8; ++v) {
      bool is_in_both = true;
      for (const Vertex own : {site, other}) {
        const std::size_t axis = static_cast<std::size_t>(own - 1) / 2;
        is_in_both &= own == 0 || sites[static_cast<std::size_t>(own)][axis] ==
                                      2 * diagram.vertices[static_cast<std::size_t>(v)][axis];
      }
      if (is_in_both) ridge.corners.push_back(v);
    }
    ridge.is_unbounded = site != 0;
    diagram.neighbors.push_back({site, other});
    diagram.ridges.push_back(ridge);
  };
  for (Vertex other = 1; other < 7; ++other) add(0, other);
  for (Vertex a = 1; a < 7; ++a) {
    for (Vertex b = a + 1; b < 7; ++b) {
      if ((a + 1) / 2 != (b + 1) / 2) add(a, b);
    }
  }
  CHECK(broken(diagram).empty());
  for (const std::size_t r : {0u, 5u, 6u, 17u}) {
    CAPTURE(r);
    VoronoiDiagram other = diagram;
    other.ridges[r].corners.pop_back();
    CHECK(broken(other) == Broken{{Rule::kRidgeDiffers, 1}});
    other.ridges.erase(other.ridges.begin() + static_cast<std::ptrdiff_t>(r));
    other.neighbors.erase(other.neighbors.begin() + static_cast<std::ptrdiff_t>(r));
    CHECK(broken(other) == Broken{{Rule::kRidgeMissing, 1}});
  }
  diagram.neighbors.push_back({1, 2});    // on opposite sides, without a common vertex
  for (const std::vector<Vertex>& ends :  // of either, of the first, of the second
       std::vector<std::vector<Vertex>>{{0, 1}, {0, 2}, {1, 3}}) {
    diagram.ridges.resize(diagram.neighbors.size() - 1);
    diagram.ridges.push_back({ends});
    CHECK(broken(diagram) == Broken{{Rule::kRidgeDiffers, 1}});
  }
  diagram.neighbors.back() = {0, 1};  // an edge of its square
  diagram.ridges.back() = {{diagram.ridges[0].corners[0], diagram.ridges[0].corners[1]}};
  CHECK(broken(diagram) == Broken{{Rule::kRidgeDiffers, 1}});
}

TEST_CASE("structure: different vertices and ridges are counted, even if a vertex is unmatched") {
  VoronoiDiagram diagram = square_with_ridges();
  diagram.vertices.push_back({2, 0});
  diagram.vertices.push_back({3, 3});
  const Verdict verdict = judge_voronoi(diagram, {}, 0, false, 0, true);
  CHECK(!verdict.holds());
  REQUIRE(verdict.voronoi->structure);
  CHECK(verdict.voronoi->structure->vertices == 5);
  CHECK(verdict.voronoi->structure->ridges == 8);
}

TEST_CASE("structure: ridges without ends cannot be judged") {
  VoronoiDiagram diagram = square_with_ridges();
  diagram.ridges.clear();
  CHECK(fault_of_structure(diagram).find("expected ridges with their ends for --structure") == 0);
  diagram.neighbors.clear();
  CHECK(fault_of_structure(diagram) != "");
  CHECK(fault_of_structure({PointSet(std::vector<Point>{{0, 0}})}) == "");
}

}  // namespace
}  // namespace circumspect::check
