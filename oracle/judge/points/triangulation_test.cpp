// Whether simplices are a complex that covers the hull: each rule broken alone, by the smallest
// mesh.
#include "oracle/judge/points/triangulation.hpp"

#include <map>
#include <set>

#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"

namespace circumspect::check {
namespace {

std::set<Rule> broken(const ExactMesh& mesh, By by) {
  std::set<Rule> rules;
  const Verdict verdict = judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = by});
  for (const auto& [rule, tally] : verdict.tallies()) rules.insert(rule);
  return rules;
}

// All violations of a mesh that breaks one rule by lemma, and some rule by definition.
std::vector<Violation> only(Rule rule, const ExactMesh& mesh) {
  CHECK(broken(mesh, By::kLemma) == std::set{rule});
  CHECK(!broken(mesh, By::kDefinition).empty());
  const Verdict verdict = judge_points(Claim::kTriangulation, mesh);
  REQUIRE(!verdict.violations().empty());
  CHECK(verdict.tallies().at(rule).count == verdict.violations().size());
  CHECK(!verdict.tallies().at(rule).worst_margin);
  return verdict.violations();
}

// Is the point in the closed simplex? The same question as in the checker, answered with
// barycentric coordinates by Cramer's rule.
bool covers(const ExactMesh& mesh, const Simplex& simplex, const Point& point) {
  std::vector<Point> with_point = mesh.points.points();
  with_point.push_back(point);
  const Configuration points(with_point);
  const Rational whole = orientation_determinant(points, points.axes(), simplex);
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const Simplex part =
        with_vertex_replaced(simplex, place, static_cast<Vertex>(with_point.size()) - 1);
    if (sign(orientation_determinant(points, points.axes(), part) / whole) < 0) return false;
  }
  return true;
}

// Every witness of a vertex beyond a facet shows two determinants of opposite signs.
void check_beyond(const ExactMesh& mesh, const Witness& witness) {
  REQUIRE(witness.simplices.size() == 1);
  REQUIRE(witness.face.has_value());
  REQUIRE(witness.vertices.size() == 1);
  REQUIRE(witness.values.size() == 2);
  CHECK(witness.values[0].name == "orientation determinant of facet and own apex");
  CHECK(witness.values[1].name == "orientation determinant of facet and vertex beyond");
  Vertex apex = -1;
  for (const Vertex v : witness.simplices[0]) {
    if (!contains(*witness.face, v)) apex = v;
  }
  const Configuration& points = mesh.points.configuration();
  Simplex simplex = *witness.face;
  simplex.push_back(apex);
  CHECK(witness.values[0].value == orientation_determinant(points, points.axes(), simplex));
  simplex.back() = witness.vertices[0];
  CHECK(witness.values[1].value == orientation_determinant(points, points.axes(), simplex));
  CHECK(sign(witness.values[0].value) * sign(witness.values[1].value) == -1);
}

TEST_CASE("facet overused: three triangles on one edge") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}, {1, -1}, {0, -2}}),
                       {{0, 1, 2}, {1, 0, 3}, {0, 4, 1}}};
  const auto violations = only(Rule::kFacetOverused, mesh);
  REQUIRE(violations.size() == 1);
  CHECK(violations[0].witness.face == Simplex{0, 1});
  CHECK(violations[0].witness.simplices == mesh.simplices);
  CHECK(broken(mesh, By::kDefinition) == std::set{Rule::kOverlap});
}

TEST_CASE("overlap: two triangles on the same side of an edge") {
  const ExactMesh mesh{PointSet({{0, 0}, {2, 0}, {0, 2}, {2, 2}}), {{0, 1, 2}, {0, 1, 3}}};
  const auto violations = only(Rule::kOverlap, mesh);
  REQUIRE(violations.size() == 1);
  const Witness& witness = violations[0].witness;
  CHECK(witness.simplices == mesh.simplices);
  REQUIRE(witness.point.has_value());
  CHECK((*witness.point)[1] > 0);  // off the common edge
  CHECK(covers(mesh, {0, 1, 2}, *witness.point));
  CHECK(covers(mesh, {0, 1, 3}, *witness.point));
  CHECK(broken(mesh, By::kDefinition) == std::set{Rule::kOverlap});
}

TEST_CASE("hull not convex, by definition: the first vertex beyond a facet is named") {
  const ExactMesh mesh{PointSet({{4, 4}, {0, 0}, {4, 0}, {0, 4}, {6, 0}}), {{1, 2, 3}, {0, 2, 4}}};
  const Verdict verdict =
      judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = By::kDefinition});
  std::map<Simplex, std::vector<Vertex>> beyond;
  for (const Violation& violation : verdict.violations()) {
    CHECK(violation.rule == Rule::kHullNotConvex);
    beyond[violation.witness.face.value_or(Simplex{})] = violation.witness.vertices;
  }
  CHECK(beyond[{2, 3}] == std::vector<Vertex>{0});
  CHECK(beyond[{0, 2}] == std::vector<Vertex>{1});
}

TEST_CASE("overlap: a boundary folded onto itself, with one edge along another") {
  // It winds around the origin from (2, 0) counterclockwise to (1, 0), which lies on the first
  // edge.
  const ExactMesh mesh{PointSet({{0, 0}, {2, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}),
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
  const auto violations = only(Rule::kOverlap, mesh);
  REQUIRE(violations.size() == 1);
  CHECK(std::set<Simplex>(violations[0].witness.simplices.begin(),
                          violations[0].witness.simplices.end()) ==
        std::set<Simplex>{{0, 1, 2}, {0, 4, 5}});
  CHECK(violations[0].witness.point == Point{1, 0});
}

TEST_CASE("hull not closed: a gap on a line, a vertex and an edge where four facets meet") {
  const ExactMesh gap{PointSet({{0}, {1}, {2}, {3}}), {{0, 1}, {2, 3}}};
  const auto on_line = only(Rule::kHullNotClosed, gap);
  REQUIRE(on_line.size() == 1);
  CHECK(on_line[0].witness.face == Simplex{});
  CHECK(on_line[0].witness.simplices == std::vector<Simplex>{{0}, {1}, {2}, {3}});
  const ExactMesh bow_tie{PointSet({{0, 0}, {2, 1}, {2, -1}, {-2, 1}, {-2, -1}}),
                          {{0, 1, 2}, {0, 3, 4}}};
  const auto pinched = only(Rule::kHullNotClosed, bow_tie);
  REQUIRE(pinched.size() == 1);
  CHECK(pinched[0].witness.face == Simplex{0});
  CHECK(pinched[0].witness.simplices == std::vector<Simplex>{{0, 1}, {0, 2}, {0, 3}, {0, 4}});
  const ExactMesh edge{
      PointSet({{0, 0, 0}, {0, 0, 2}, {1, 1, 1}, {1, -1, 1}, {-1, 1, 1}, {-1, -1, 1}}),
      {{0, 1, 2, 3}, {0, 1, 4, 5}}};
  const auto edges = only(Rule::kHullNotClosed, edge);
  REQUIRE(edges.size() == 1);
  CHECK(edges[0].witness.face == Simplex{0, 1});
  CHECK(edges[0].witness.simplices.size() == 4);
}

TEST_CASE("hull not convex: a notch, met at the reflex vertex") {
  const ExactMesh mesh{PointSet({{0, 0}, {4, 0}, {1, 1}, {0, 4}}), {{0, 1, 2}, {0, 2, 3}}};
  const auto violations = only(Rule::kHullNotConvex, mesh);
  REQUIRE(violations.size() == 1);
  check_beyond(mesh, violations[0].witness);
  CHECK(abs(violations[0].witness.values[0].value) == 4);  // twice the area of {0, 1, 2}
  CHECK(abs(violations[0].witness.values[1].value) == 8);  // and of the notch
}

TEST_CASE("hull not convex: two pieces, each convex, apart and touching in a point of space") {
  const ExactMesh apart{PointSet({{0, 0}, {1, 0}, {0, 1}, {5, 5}, {6, 5}, {5, 6}}),
                        {{0, 1, 2}, {3, 4, 5}}};
  for (const Violation& violation : only(Rule::kHullNotConvex, apart)) {
    check_beyond(apart, violation.witness);
    CHECK(violation.witness.simplices[0] == Simplex{3, 4, 5});
    CHECK(violation.witness.vertices[0] < 3);
  }
  const ExactMesh touching{
      PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}),
      {{0, 1, 2, 3}, {0, 4, 5, 6}}};
  for (const Violation& violation : only(Rule::kHullNotConvex, touching)) {
    check_beyond(touching, violation.witness);
  }
}

// The sample point lies exactly in the hyperplane of a boundary facet of another piece.
TEST_CASE("hull not convex: the sample point in the plane of a facet is not on its inner side") {
  const ExactMesh mesh{PointSet({{0, -1}, {3, -1}, {0, 2}, {4, 0}, {6, 0}, {5, 3}}),
                       {{0, 1, 2}, {3, 4, 5}}};
  REQUIRE(barycentre(mesh.points, {0, 1, 2}) == Point{1, 0});
  bool on_line = false;
  for (const Violation& violation : only(Rule::kHullNotConvex, mesh)) {
    check_beyond(mesh, violation.witness);
    on_line |= violation.witness.face == Simplex{3, 4};
  }
  CHECK(on_line);
}

// Local convexity and one sample point do not suffice: every edge of this fan is matched, the
// boundary is one locally convex cycle, and it winds around the origin twice.
const std::vector<Point> kRing = {{14280, 6877}, {-7858, 9854}, {-4612, -5783}, {3739, -1801},
                                  {1181, 5176},  {-10000, 0},   {3269, -14323}};

TEST_CASE("covered twice: a fan that winds twice, every edge of it locally Delaunay") {
  std::vector<Point> points = {{0, 0}};
  points.insert(points.end(), kRing.begin(), kRing.end());
  std::vector<Simplex> fan;
  for (Vertex i = 2; i < 9; ++i) fan.push_back({0, 1 + i % 7, 1 + (i + 1) % 7});
  const ExactMesh mesh{PointSet(points), fan};
  const auto violations = only(Rule::kCoveredTwice, mesh);
  for (const Violation& violation : violations) {
    REQUIRE(violation.witness.simplices.size() == 2);
    REQUIRE(violation.witness.point.has_value());
    CHECK(violation.witness.point == barycentre(mesh.points, fan[0]));
    for (const Simplex& simplex : violation.witness.simplices) {
      CHECK(covers(mesh, simplex, *violation.witness.point));
    }
    CHECK(violation.witness.simplices[0] == fan[0]);
    CHECK(violation.witness.simplices[1] != fan[0]);
  }
  const Verdict verdict = judge_points(Claim::kDelaunay, mesh);
  CHECK(verdict.tallies().size() == 1);
  CHECK(verdict.tallies().contains(Rule::kCoveredTwice));
  // Whichever triangle comes first, something stops it.
  for (std::size_t first = 0; first < fan.size(); ++first) {
    ExactMesh rotated = mesh;
    std::swap(rotated.simplices[0], rotated.simplices[first]);
    CHECK(!judge_points(Claim::kTriangulation, rotated).holds());
  }
}

TEST_CASE("covered twice: the same in space, a cone over the fan and a double cone") {
  std::vector<Point> points = {{0, 0, 0}, {0, 0, 3000}, {0, 0, -3000}};
  for (const Point& p : kRing) points.push_back({p[0], p[1], 0});
  std::vector<Simplex> cone;
  std::vector<Simplex> double_cone;
  for (Vertex i = 2; i < 9; ++i) {
    const Vertex a = 3 + i % 7;
    const Vertex b = 3 + (i + 1) % 7;
    cone.push_back({0, 1, a, b});
    double_cone.push_back({1, 2, a, b});
  }
  std::vector<Point> without_nadir = points;
  without_nadir.erase(without_nadir.begin() + 2);
  std::vector<Simplex> renumbered = cone;
  for (Simplex& simplex : renumbered) {
    for (Vertex& v : simplex) v -= v > 2 ? 1 : 0;
  }
  only(Rule::kCoveredTwice, {PointSet(without_nadir), renumbered});
  points.erase(points.begin());
  for (Simplex& simplex : double_cone) {
    for (Vertex& v : simplex) --v;
  }
  only(Rule::kCoveredTwice, {PointSet(points), double_cone});
}

TEST_CASE("covered twice: a small triangle within a large one, also where it touches the sample") {
  const ExactMesh nested{PointSet({{0, 0}, {9, 0}, {0, 9}, {2, 2}, {5, 2}, {2, 5}}),
                         {{0, 1, 2}, {3, 4, 5}}};
  CHECK(broken(nested, By::kLemma) == std::set{Rule::kCoveredTwice});
  CHECK(broken(nested, By::kDefinition) == std::set{Rule::kOverlap});
  // The sample point (3, 3) is on an edge inside the other piece: it is covered, though not
  // strictly.
  const ExactMesh touching{PointSet({{0, 0}, {9, 0}, {0, 9}, {3, 2}, {3, 4}, {1, 3}, {5, 3}}),
                           {{0, 1, 2}, {3, 4, 5}, {3, 4, 6}}};
  CHECK(broken(touching, By::kLemma) == std::set{Rule::kCoveredTwice});
  CHECK(judge_points(Claim::kTriangulation, touching).tallies().at(Rule::kCoveredTwice).count == 2);
}

TEST_CASE("hull not convex: while a piece is apart, none is asked whether it covers the sample") {
  const ExactMesh three{
      PointSet({{0, 0}, {9, 0}, {0, 9}, {2, 2}, {5, 2}, {2, 5}, {20, 20}, {21, 20}, {20, 21}}),
      {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}};
  CHECK(broken(three, By::kLemma) == std::set{Rule::kHullNotConvex});
}

TEST_CASE("coplanar boundary facets are not a fault, nor is a single simplex") {
  const ExactMesh split{PointSet({{0, 0}, {1, 0}, {2, 0}, {1, 1}}), {{0, 1, 3}, {1, 2, 3}}};
  CHECK(broken(split, By::kLemma).empty());
  CHECK(broken(split, By::kDefinition).empty());
  const ExactMesh space{PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 1}}),
                        {{0, 1, 3, 4}, {1, 2, 3, 4}}};
  CHECK(broken(space, By::kLemma).empty());
  CHECK(broken(space, By::kDefinition).empty());
  CHECK(broken({PointSet({{0, 0}, {1, 0}, {0, 1}}), {{2, 0, 1}}}, By::kLemma).empty());
}

}  // namespace
}  // namespace circumspect::check
