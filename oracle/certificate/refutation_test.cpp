// Refutations, which the acceptor accepts.
#include <algorithm>
#include <sstream>

#include <doctest/doctest.h>

#include "oracle/certificate/accepted_test.hpp"
#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"

namespace circumspect::certificate {
namespace {

// The rule and the line of evidence, which the acceptor has accepted.
std::string because(const ExactMesh& mesh, Claim claim = Claim::kDelaunay,
                    const check::Options& options = {}) {
  const Verdict verdict = check::judge_exactly(claim, mesh, nullptr, options);
  REQUIRE(!verdict.holds());
  const auto document = document_of(mesh, verdict);
  REQUIRE(document);
  const std::string text = text_of(mesh, *document);
  CHECK(fault_of(mesh, verdict, text) == "");
  const std::size_t at = text.find("\nbecause ") + 9;
  return refuted_rule(mesh, verdict) + ": " + text.substr(at, text.find('\n', at) - at);
}

const std::vector<Point> kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST_CASE("the refutation of a mesh, as it stands in the file") {
  const ExactMesh mesh{PointSet(kSquare), {{0, 1, 2}, {0, -5, 9, 9}}, {4, 5, 6, 7}};
  const Verdict verdict = check::judge_points(Claim::kTriangulation, mesh);
  CHECK(text_of(mesh, *document_of(mesh, verdict)) ==
        "circumspect-refutation 2 triangulation 2 triangulation.unknown-vertex\n"
        "scale 2 1\n"
        "points 4\n"
        "0 0  4\n"
        "1 0  5\n"
        "1 1  6\n"
        "0 1  7\n"
        "simplices 2\n"
        "3  1 2 3\n"
        "4  1 -4 10 10\n"
        "spans 1 2 3\n"
        "because 2 1\n"
        "end\n");
}

// Of points that do not span, and of surfaces.
std::string written(const ExactMesh& mesh, Claim claim) {
  const Verdict verdict = check::judge_exactly(claim, mesh, nullptr, {});
  const auto document = document_of(mesh, verdict);
  REQUIRE(document);
  const std::string text = text_of(mesh, *document);
  return text.substr(0, text.find('\n') + 1) + text.substr(text.find("spans"));
}

TEST_CASE("of points that do not span a refutation says how they lie") {
  const PointSet line({{0, 0}, {2, 2}, {1, 1}});
  CHECK(written({line, {{0, 1, 2}}}, Claim::kDelaunay) ==
        "circumspect-refutation 2 delaunay 2 simplex.wrong-dimension flat\n"
        "spans 1 2\npads 1\n0 1\nbecause 1\nend\n");
  CHECK(written({line, {{0, 2}}}, Claim::kTriangulation) ==
        "circumspect-refutation 2 triangulation 2 triangulation.unused-point flat\n"
        "spans 1 2\npads 1\n0 1\nbecause 2\nend\n");
  // The longer diagonal of a quadrilateral in the plane z = x: point 4 is in the ball of the first.
  const PointSet plane({{0, 0, 0}, {2, -1, 2}, {4, 0, 4}, {2, 1, 2}});
  CHECK(written({plane, {{0, 1, 2}, {2, 3, 0}}}, Claim::kDelaunay) ==
        "circumspect-refutation 2 delaunay 3 delaunay.vertex-in-ball flat\n"
        "spans 1 2 3\npads 1\n0 0 1\nbecause 1 4 -1 1 -1 1\nend\n");
}

TEST_CASE("on a line with a gap, an edge ends where no other begins, and a point lies beyond") {
  constexpr Vertex kPoints = 6;
  const std::vector<Vertex> order = {3, 0, 5, 1, 4, 2};  // along the line
  std::vector<Point> points(kPoints);
  for (long place = 0; place < kPoints; ++place) {
    points[static_cast<std::size_t>(order[static_cast<std::size_t>(place)])] = {2 * place, -place};
  }
  std::size_t told = 0;
  for (unsigned subset = 0; subset < 31; ++subset) {  // of the edges, not all
    ExactMesh mesh{PointSet(points), {}};
    std::vector<std::size_t> uses(kPoints);
    for (std::size_t i = 0; i + 1 < kPoints; ++i) {
      if ((subset >> i & 1U) == 0) continue;
      const bool is_back = (i + subset) % 2 == 1;
      mesh.simplices.push_back({order[is_back ? i + 1 : i], order[is_back ? i : i + 1]});
      for (const Vertex v : mesh.simplices.back()) ++uses[static_cast<std::size_t>(v)];
    }
    if (std::count(uses.begin(), uses.end(), 0U) > 0) continue;
    ++told;
    const std::string text = written(mesh, Claim::kTriangulation);
    CHECK(text.starts_with(
        "circumspect-refutation 2 triangulation 2 triangulation.hull-not-convex flat\n"));
    std::istringstream because(text.substr(text.find("because ") + 8));
    std::size_t edge = 0, start = 0, beyond = 0;  // places are counted from 0
    because >> edge >> start >> beyond;
    const Simplex& simplex = mesh.simplices.at(edge - 1);
    const Vertex end = simplex.at(1 - start);
    CHECK(uses[static_cast<std::size_t>(end)] == 1);
    const auto at = [&](Vertex v) { return points[static_cast<std::size_t>(v)][0]; };
    const Rational onward = at(end) - at(simplex.at(start));
    CHECK(sign(Rational(onward * (at(static_cast<Vertex>(beyond) - 1) - at(end)))) > 0);
  }
  CHECK(told == 4);
}

TEST_CASE("of a mesh alone the first fault that can be shown, most of full dimension only") {
  const auto refuted = [](const PointSet& points, const std::vector<Simplex>& simplices) {
    const ExactMesh mesh{points, simplices};
    const Verdict verdict = check::judge_complex({points.points(), simplices}, {}, false, 20);
    REQUIRE(!verdict.holds());
    const auto document = document_of(mesh, verdict);
    return document ? refuted_rule(mesh, verdict) : document.error();
  };
  const PointSet plane(kSquare), space({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 2}});
  CHECK(refuted(plane, {{0, 1, 7}, {1, 2, 3}}) == "triangulation.unknown-vertex");
  CHECK(refuted(plane, {{0, 1, 1}, {1, 2, 3}}) == "simplex.repeated-vertex");
  CHECK(refuted(plane, {{0, 1, 2}}) == "triangulation.unused-point");
  CHECK(refuted(plane, {{0, 1, 2}, {1, 2, 0}, {0, 2, 3}}) == "complex.duplicate-simplex");
  CHECK(refuted(plane, {{0, 1, 2}, {0, 1, 3}}) == "complex.overlap");
  CHECK(refuted(space, {{0, 1, 2}, {2, 3, 9}, {2, 3, 4}}) == "triangulation.unknown-vertex");
  const std::string none =
      "there is no refutation of this mesh: of simplices of a lower dimension, or of another than "
      "the first, none shows ";
  CHECK(refuted(space, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}) == none + "complex.overlap");
  CHECK(refuted(space, {{0, 1, 2}, {0, 2, 1}, {2, 3, 4}}) == none + "complex.duplicate-simplex");
}

TEST_CASE("points on both sides of a facet of a hull") {
  const ExactMesh cut{PointSet(kSquare), {{0, 1}, {1, 3}, {3, 0}}};
  const Verdict verdict = check::judge_exactly(Claim::kConvexHull, cut, nullptr, {});
  const std::string text = text_of(cut, *document_of(cut, verdict));
  CHECK(text.find("circumspect-refutation 2 convex-hull 2 hull.facet-not-supporting\n") == 0);
  CHECK(text.find("simplices 3\n2  1 2\n2  2 4\n2  4 1\nbecause 2 ") != std::string::npos);
}

TEST_CASE("an edge of a surface that is not Delaunay") {
  const ExactMesh wide{PointSet({{0, 0}, {4, -1}, {4, 1}, {8, 0}}), {{0, 1, 3}, {0, 3, 2}}};
  const Verdict verdict = check::judge_exactly(Claim::kSurfaceDelaunay, wide, nullptr, {});
  CHECK(text_of(wide, *document_of(wide, verdict)) ==
        "circumspect-refutation 2 surface-delaunay 2 surface.edge-not-delaunay\nscale 1 1\n"
        "points 4\n0 0  0\n4 -1  1\n4 1  2\n8 0  3\n"
        "simplices 2\n3  1 2 4\n3  1 4 3\nbecause 1 1 2 2\nend\n");
  // Of a triangle that is listed twice the edge is one of three rows.
  const ExactMesh twice{wide.points, {{0, 1, 3}, {0, 3, 2}, {3, 2, 0}}};
  CHECK(!document_of(twice, check::judge_exactly(Claim::kSurfaceDelaunay, twice, nullptr, {})));
}

TEST_CASE("simplices by themselves and as lists of vertices") {
  const PointSet points(kSquare);
  CHECK(because({points, {{0, 1, 2}, {0, 2}}}) == "simplex.wrong-dimension: 2");
  CHECK(because({points, {{0, 1, 2}, {}}}) == "simplex.wrong-dimension: 2");
  CHECK(because({points, {{0, 1, 2}, {2, 3, 2}}}) == "simplex.repeated-vertex: 2 0 2");
  CHECK(because({points, {{0, 1, 2}, {3, 0, 2}, {2, 0, 3}}}) == "complex.duplicate-simplex: 2 3");
  CHECK(because({points, {{0, 1, 2}}}) == "triangulation.unused-point: 4");
  CHECK(because({points, {}}) == "triangulation.unused-point: 1");
  const PointSet with_middle({{0, 0}, {2, 0}, {1, 0}, {1, 1}});
  CHECK(because({with_middle, {{0, 1, 3}, {0, 1, 2}}}) == "simplex.degenerate: 2");
  const PointSet above({{0, 0}, {2, 0}, {1, 1}, {1, 2}, {1, -1}});
  CHECK(because({above, {{0, 1, 2}, {0, 1, 3}, {4, 0, 1}}}) ==
        "complex.facet-overused: 1 2 2 2 3 0");
}

TEST_CASE("of faults of several kinds the first is refuted") {
  CHECK(because({PointSet(kSquare), {{0, 1, 9}, {0, 2}, {1, 1, 2}}}) ==
        "triangulation.unknown-vertex: 1 2");
}

TEST_CASE("two simplices on one side of a facet have a point in common") {
  const PointSet points({{0, 0}, {2, 0}, {1, 1}, {1, 2}});
  CHECK(because({points, {{0, 1, 2}, {0, 1, 3}}}).find("complex.overlap: 1 2 ") == 0);
}

TEST_CASE("a notch is uncovered") {
  const ExactMesh notched{PointSet({{0, 0}, {4, 1}, {8, 0}, {4, 7}}), {{0, 1, 3}, {1, 2, 3}}};
  CHECK(because(notched, Claim::kTriangulation) == "triangulation.hull-not-convex: 1 2 3");
}

TEST_CASE("where a hull is not closed, three facets of the boundary share a ridge") {
  const ExactMesh bow_tie{PointSet({{0, 0}, {-2, 1}, {-2, -1}, {2, 1}, {2, -1}}),
                          {{0, 1, 2}, {0, 3, 4}}};
  CHECK(because(bow_tie) == "triangulation.hull-not-closed: 1 2 1 1 2 2");
}

TEST_CASE("where a vertex hangs in an edge, the hull is not closed, and nothing is covered twice") {
  // A T-junction: the edge from 0 to 1 against those from 0 to 4 and from 4 to 1.
  const ExactMesh junction{PointSet({{0, 0}, {4, 0}, {2, 2}, {2, -2}, {2, 0}}),
                           {{0, 1, 2}, {0, 4, 3}, {4, 1, 3}}};
  CHECK(because(junction) == "triangulation.hull-not-closed: 1 2 1 1 2 1");
}

TEST_CASE("where all of the hull is covered, it may not be closed all the same") {
  // The square covered by a fan about its centre that has the midpoints of its edges, and by two
  // triangles that have not: corners are in four boundary facets, and nothing is beyond any.
  const PointSet points({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}, {1, 2}});
  std::vector<Simplex> simplices = {{0, 2, 4}, {0, 4, 6}};
  for (Vertex v = 0; v < 8; ++v) simplices.push_back({v, (v + 1) % 8, 8});
  const ExactMesh mesh{points, simplices};
  CHECK(check::judge_points(Claim::kDelaunay, mesh).tallies().begin()->first ==
        Rule::kHullNotClosed);
  CHECK(because(mesh).find("triangulation.hull-not-closed: ") == 0);
}

TEST_CASE("a fan that winds twice covers points twice") {
  const ExactMesh fan{
      PointSet({{0, 0},
                {14280, 6877},
                {-7858, 9854},
                {-4612, -5783},
                {3739, -1801},
                {1181, 5176},
                {-10000, 0},
                {3269, -14323}}),
      {{0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 1}, {0, 1, 2}, {0, 2, 3}}};
  CHECK(because(fan).find("triangulation.covered-twice: 1 4 ") == 0);
}

TEST_CASE("balls that are not empty") {
  const PointSet kite({{0, 0}, {2, -3}, {4, 0}, {2, 3}});
  const ExactMesh tall{kite, {{3, 0, 1}, {1, 2, 3}}};
  const ExactMesh flat{PointSet({{0, 0}, {2, -1}, {4, 0}, {2, 1}}), {{0, 1, 2}, {2, 3, 0}}};
  CHECK(because(tall, Claim::kDelaunay).empty() == false);
  CHECK(because(flat) == "delaunay.facet-not-local: 1 1 2 1");
  CHECK(because(flat, Claim::kDelaunay, {.by = check::By::kDefinition}) ==
        "delaunay.vertex-in-ball: 1 4");
}

TEST_CASE("weights: points below planes, submerged vertices, points outside") {
  const std::vector<Point> with_centre = {{0, 0}, {4, 0}, {0, 4}, {1, 1}};
  const auto weighted = [&](const Rational& of_centre, const std::vector<Simplex>& simplices) {
    return because({PointSet(with_centre, {0, 0, 0, of_centre}), simplices},
                   Claim::kWeightedDelaunay);
  };
  const std::vector<Simplex> fan = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  CHECK(weighted(1, {{0, 1, 2}}) == "weighted.point-below-plane: 1 4");
  CHECK(weighted(-100, fan).find("weighted.vertex-submerged: 1 2 ") == 0);
  // A point that no simplex covers has to be covered, though not used.
  CHECK(weighted(-100, {{0, 1, 3}}) == "triangulation.unused-point: 3 0");
  CHECK(weighted(0, {}) == "triangulation.unused-point: 1");
  const ExactMesh flat{PointSet({{0, 0}, {2, -1}, {4, 0}, {2, 1}}, {0, 0, 0, 0}),
                       {{0, 1, 2}, {2, 3, 0}}};
  CHECK(because(flat, Claim::kWeightedDelaunay) == "delaunay.facet-not-local: 1 1 2 1");
}

TEST_CASE("a fault that is none of the claim has no refutation") {
  const ExactMesh turned{PointSet(kSquare), {{0, 1, 2}, {0, 3, 2}}};
  const Verdict verdict = check::judge_points(Claim::kDelaunay, turned, {.oriented = true});
  CHECK(!verdict.holds());
  const auto document = document_of(turned, verdict);
  REQUIRE(!document);
  CHECK(document.error().find("simplex.orientation") != std::string::npos);
  // Another fault beside it has one.
  const ExactMesh flat{PointSet({{0, 0}, {2, -1}, {4, 0}, {2, 1}}), {{0, 1, 2}, {0, 3, 2}}};
  CHECK(because(flat, Claim::kDelaunay, {.oriented = true}) == "delaunay.facet-not-local: 1 1 2 1");
}

TEST_CASE("a verdict without room for witnesses is refuted all the same") {
  const PointSet points(kSquare);
  CHECK(because({points, {{0, 1, 2}, {0, 2}}}, Claim::kDelaunay, {.max_violations = 1}) ==
        "simplex.wrong-dimension: 2");
  // The orientation takes the only room.
  const ExactMesh flat{PointSet({{0, 0}, {2, -1}, {4, 0}, {2, 1}}), {{0, 1, 2}, {0, 3, 2}}};
  CHECK(because(flat, Claim::kDelaunay, {.oriented = true, .max_violations = 1}) ==
        "delaunay.facet-not-local: 1 1 2 1");
}

// So that what the acceptor accepts says something.
TEST_CASE("the acceptor of the tests refuses what shows nothing") {
  const std::string mesh =
      "scale 1 1\npoints 4\n0 0 1\n2 0 2\n2 2 3\n0 2 4\nsimplices 2\n3 1 2 3\n3 1 3 4\n"
      "spans 1 2 3\nbecause ";
  const auto accepted = [&](const std::string& rule, const std::string& evidence) {
    const std::string kind = rule.substr(0, 8) == "weighted" ? "weighted-delaunay" : "delaunay";
    return RefutationAcceptor("circumspect-refutation 2 " + kind + " 2 " + rule + "\n" + mesh +
                              evidence + "\nend\n")
        .accepts();
  };
  CHECK(!accepted("simplex.wrong-dimension", "1"));
  CHECK(!accepted("triangulation.unknown-vertex", "1 0"));
  CHECK(!accepted("simplex.repeated-vertex", "1 1 1"));
  CHECK(!accepted("simplex.repeated-vertex", "1 0 1"));
  CHECK(!accepted("simplex.degenerate", "1"));
  CHECK(!accepted("complex.duplicate-simplex", "1 2"));
  CHECK(!accepted("complex.duplicate-simplex", "1 1"));
  CHECK(!accepted("complex.facet-overused", "1 1 2 2 1 1"));
  CHECK(!accepted("complex.overlap", "1 2 1 1 1"));
  CHECK(!accepted("triangulation.unused-point", "4"));
  CHECK(!accepted("triangulation.covered-twice", "1 2 1 1 1"));
  CHECK(!accepted("triangulation.hull-not-convex", "1 1 4"));
  CHECK(!accepted("triangulation.hull-not-convex", "1 0 4"));
  CHECK(!accepted("triangulation.hull-not-closed", "1 2 2 1 2 0"));
  CHECK(!accepted("delaunay.vertex-in-ball", "1 4"));
  CHECK(!accepted("delaunay.facet-not-local", "1 1 2 2"));
}

}  // namespace
}  // namespace circumspect::certificate
