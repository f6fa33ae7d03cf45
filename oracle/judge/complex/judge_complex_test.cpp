// The claim `complex`, by lemma and by definition: what each kind of fault is called, and what is
// found where every facet and every ridge is as it should be.
#include "oracle/judge/complex/judge_complex.hpp"

#include <algorithm>
#include <bit>
#include <random>

#include <doctest/doctest.h>

namespace circumspect::check {
namespace {

using definition::ListedComplex;

using Tallies = std::map<Rule, std::size_t>;

Tallies tallies_of(const ListedComplex& mesh, const ComplexDemands& demands, bool by_definition,
                   std::size_t max_violations = 0) {
  const Verdict verdict = judge_complex(mesh, demands, by_definition, max_violations);
  CHECK(verdict.holds() == verdict.tallies().empty());
  Tallies tallies;
  std::size_t all = 0;
  for (const auto& [rule, tally] : verdict.tallies()) all += tallies[rule] = tally.count;
  if (max_violations == 0) CHECK(verdict.violations().size() == all);
  return tallies;
}

// The tallies of both ways, which are the same: also of the simplices from the last to the first,
// and however few witnesses are kept.
Tallies broken(const ListedComplex& mesh, const ComplexDemands& demands = {}) {
  const Tallies tallies = tallies_of(mesh, demands, false);
  CHECK(tallies == tallies_of(mesh, demands, true));
  CHECK(tallies == tallies_of(mesh, demands, false, 1));
  ListedComplex reversed = mesh;
  std::reverse(reversed.simplices.begin(), reversed.simplices.end());
  CHECK(tallies == tallies_of(reversed, demands, false));
  return tallies;
}

const std::vector<Point> kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {2, 1}, {1, 2}};

TEST_CASE("a triangle inside another breaks no condition of facets and ridges") {
  CHECK(broken({kSquare, {{0, 1, 3}, {4, 5, 6}, {1, 2, 3}}}) == Tallies{{Rule::kOverlap, 1}});
  // In its hole it is right.
  const std::vector<Point> with_hole = {{0, 0},  {20, 0}, {0, 20}, {2, 2}, {12, 2},
                                        {2, 12}, {4, 4},  {5, 4},  {4, 5}};
  const std::vector<Simplex> frame = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4},
                                      {2, 5, 4}, {2, 0, 5}, {0, 3, 5}};
  CHECK(broken({{with_hole.begin(), with_hole.begin() + 6}, frame}).empty());
  std::vector<Simplex> filled = frame;
  filled.push_back({6, 7, 8});
  CHECK(broken({with_hole, filled}).empty());
  filled.push_back({3, 4, 5});
  CHECK(broken({with_hole, filled}) == Tallies{{Rule::kOverlap, 1}});
}

TEST_CASE("a simplex overlaps with one inside of it, whatever face they share, and their numbers") {
  const std::vector<Point> plane = {{0, 0}, {8, 0}, {0, 8}, {2, 2}, {3, 2}, {2, 3}};
  const std::vector<Point> space = {{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12},
                                    {2, 2, 2}, {3, 2, 2},  {2, 3, 2},  {2, 2, 3}};
  std::mt19937 random(1);
  for (const std::vector<Point>& points : {plane, space}) {
    const auto size = static_cast<Vertex>(points.size() / 2);
    Simplex outer, inner;
    for (Vertex v = 0; v < size; ++v) {
      outer.push_back(v);
      inner.push_back(size + v);
    }
    for (Vertex common = 0; common < size; ++common) {  // vertices of the face
      CAPTURE(common);
      for (int numbering = 0; numbering < 20; ++numbering) {
        Simplex number = first_subset(points.size());
        std::shuffle(number.begin(), number.end(), random);
        ListedComplex mesh{points, {outer, inner}};
        for (std::size_t v = 0; v < points.size(); ++v) {
          mesh.points[static_cast<std::size_t>(number[v])] = points[v];
        }
        for (Simplex& simplex : mesh.simplices) {
          for (Vertex& v : simplex) v = number[static_cast<std::size_t>(v)];
        }
        CHECK(broken(mesh, {.allow_unused = true}) == Tallies{{Rule::kOverlap, 1}});
      }
      inner[static_cast<std::size_t>(common)] = common;
    }
  }
}

TEST_CASE("what is set apart is named, its vertices are used, and the others are judged") {
  const ListedComplex mesh{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {4, 4}},
                           {{0, 1, 2}, {2, 1, 0}, {0, 4, 1}, {0, 5, 3}, {0, 0, 3}, {0, 1, 9}}};
  CHECK(broken(mesh) == Tallies{{Rule::kPointsEqual, 1},
                                {Rule::kDuplicateSimplex, 1},
                                {Rule::kDegenerateSimplex, 1},
                                {Rule::kRepeatedVertex, 1},
                                {Rule::kUnknownVertex, 1}});
  const ComplexFacts facts = *judge_complex(mesh, {}, false, 0).complex;
  CHECK(facts.set_apart == 4);
  CHECK(facts.is_complex);
  CHECK(facts.parts == 1);
  CHECK(facts.boundary_facets == 4);
  CHECK(facts.positive == 2);
  CHECK(facts.negative == 0);
}

TEST_CASE("points alone have no orientation that could differ") {
  const ListedComplex two{{{0, 0}, {4, 0}}, {{0}, {1}}};
  CHECK(broken(two, {.oriented = Orientations::kSame}).empty());
}

TEST_CASE("hanging vertices are allowed, and points of no simplex") {
  const ListedComplex mesh{{{0, 0}, {4, 0}, {0, 4}, {4, 4}, {2, 2}, {9, 9}},
                           {{0, 1, 4}, {0, 4, 2}, {1, 3, 2}}};
  CHECK(broken(mesh) == Tallies{{Rule::kHangingVertex, 1}, {Rule::kUnusedPoint, 1}});
  CHECK(broken(mesh, {.allow_hanging = true}) == Tallies{{Rule::kUnusedPoint, 1}});
  CHECK(broken(mesh, {.allow_hanging = true, .allow_unused = true}).empty());
  const ComplexFacts facts = *judge_complex(mesh, {.allow_hanging = true}, false, 0).complex;
  CHECK(facts.hanging_vertices == 1);
  CHECK(facts.is_complex);
  CHECK(!judge_complex(mesh, {}, false, 0).complex->is_complex);
}

TEST_CASE("vertices hang between parts only, unless facets lead from one side to the other") {
  ListedComplex mesh{{{0, 0}, {4, 0}, {0, 4}, {4, 4}, {2, 2}, {-2, 9}},
                     {{0, 1, 4}, {0, 4, 2}, {1, 3, 2}}};
  CHECK(judge_complex(mesh, {}, false, 0).complex->only_parts_hang);
  mesh.simplices.push_back({2, 3, 5});
  CHECK(judge_complex(mesh, {}, false, 0).complex->only_parts_hang);
  mesh.simplices.push_back({0, 2, 5});
  CHECK(!judge_complex(mesh, {}, false, 0).complex->only_parts_hang);
}

// Two triangles of which one has a vertex in an edge of the other, and so many about one point that
// 50,000 pairs overlap.
TEST_CASE("where too many overlap, nothing else is named") {
  ListedComplex mesh{{{100, 0}, {104, 0}, {100, 4}, {102, 0}, {101, -2}, {103, -2}},
                     {{0, 1, 2}, {3, 4, 5}}};
  CHECK(tallies_of(mesh, {}, false).contains(Rule::kHangingVertex));
  for (int i = 1; i <= 330; ++i) {
    const auto first = static_cast<Vertex>(mesh.points.size());
    const Rational turn = Rational(i, 400);
    mesh.points.insert(mesh.points.end(), {{-4 + turn, -4}, {4, -4 + turn}, {turn, 8}});
    mesh.simplices.push_back({first, first + 1, first + 2});
  }
  const Verdict verdict = judge_complex(mesh, {}, false, 1);
  CHECK(verdict.complex->are_counts_cut);
  CHECK(verdict.tallies().size() == 1);
  CHECK(verdict.tallies().at(Rule::kOverlap).count >= 50'000);
}

TEST_CASE("overlaps of different parts are counted, and the pairs of parts that have any") {
  // A square of two triangles, a triangle across its diagonal, and one that is far away.
  const ListedComplex mesh{
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}, {2, 1}, {3, 3}, {9, 9}, {9, 8}, {8, 9}},
      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
  CHECK(broken(mesh) == Tallies{{Rule::kOverlap, 2}});
  const ComplexFacts facts = *judge_complex(mesh, {}, false, 0).complex;
  CHECK(facts.parts == 3);
  CHECK(facts.overlaps_of_parts == 2);
  CHECK(facts.overlapping_parts == 1);
}

TEST_CASE("in a mirror positive simplices are negative, and those of the rarer sign are named") {
  const std::vector<Point> strip = {{0, 0}, {0, 4}, {4, 0}, {4, 4}, {8, 0}, {8, 4}};
  for (unsigned turned = 0; turned < 16; ++turned) {
    CAPTURE(turned);
    ListedComplex mesh{strip, {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}}};
    for (unsigned s = 0; s < 4; ++s) {
      if ((turned >> s & 1) != 0) std::swap(mesh.simplices[s][0], mesh.simplices[s][1]);
    }
    ListedComplex mirrored = mesh;
    for (Point& point : mirrored.points) point[0] = -point[0];
    const auto negative = static_cast<std::size_t>(std::popcount(turned));
    const auto tallies = [](Rule rule, std::size_t count) {
      return count == 0 ? Tallies{} : Tallies{{rule, count}};
    };
    CHECK(broken(mesh, {.oriented = Orientations::kPositive}) ==
          tallies(Rule::kInverted, negative));
    CHECK(broken(mirrored, {.oriented = Orientations::kNegative}) ==
          tallies(Rule::kInverted, negative));
    CHECK(broken(mirrored, {.oriented = Orientations::kPositive}) ==
          tallies(Rule::kInverted, 4 - negative));
    for (const ListedComplex& one : {mesh, mirrored}) {
      CHECK(broken(one, {.oriented = Orientations::kSame}) ==
            tallies(Rule::kOrientation, std::min(negative, 4 - negative)));
    }
  }
}

TEST_CASE("orientations: one sign, a sign, and neighbours of a surface") {
  const ListedComplex two{{kSquare.begin(), kSquare.begin() + 4}, {{0, 1, 2}, {0, 3, 2}}};
  CHECK(broken(two, {.oriented = Orientations::kSame}) == Tallies{{Rule::kOrientation, 1}});
  CHECK(broken(two, {.oriented = Orientations::kPositive}) == Tallies{{Rule::kInverted, 1}});
  CHECK(broken(two, {.oriented = Orientations::kNegative}) == Tallies{{Rule::kInverted, 1}});
  const ListedComplex surface{{{0, 0, 0}, {4, 0, 1}, {4, 4, 0}, {0, 4, 1}}, {{0, 1, 2}, {0, 3, 2}}};
  CHECK(broken(surface, {.oriented = Orientations::kSame}) == Tallies{{Rule::kNotOriented, 1}});
  const ListedComplex turned{surface.points, {{0, 1, 2}, {0, 2, 3}}};
  CHECK(broken(turned, {.oriented = Orientations::kSame}).empty());
  // The sign of a tetrahedron is that of det[p1 − p0; p2 − p0; p3 − p0].
  const ListedComplex corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
  CHECK(broken(corner, {.oriented = Orientations::kPositive}).empty());
}

TEST_CASE("manifold: three triangles at an edge, and a ring of tetrahedra around a vertex") {
  const ComplexDemands manifold{.manifold = true};
  const std::vector<Point> book = {{0, 0, 0}, {0, 0, 4}, {3, 0, 2}, {-3, 1, 2}, {0, -3, 2}};
  CHECK(broken({book, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}}).empty());
  CHECK(broken({book, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}}, manifold) ==
        Tallies{{Rule::kNotManifold, 1}});
  const std::vector<Point> around = {{2, 2, 3},   {-2, 2, 3},   {-2, -2, 3}, {2, -2, 3}, {2, 2, -3},
                                     {-2, 2, -3}, {-2, -2, -3}, {2, -2, -3}, {0, 0, 0}};
  std::vector<Simplex> ring;
  for (Vertex i = 0; i < 4; ++i) {
    const Vertex next = (i + 1) % 4;
    ring.push_back({8, i, next, i + 4});
    ring.push_back({8, next, i + 4, next + 4});
  }
  CHECK(broken({around, ring}).empty());
  CHECK(broken({around, ring}, manifold) == Tallies{{Rule::kNotManifold, 1}});
  ring.pop_back();
  ring.pop_back();
  CHECK(broken({around, ring}, manifold).empty());
  CHECK(broken({kSquare, {{0, 1, 5}, {0, 6, 3}}}, {.connected = true, .allow_unused = true}) ==
        Tallies{{Rule::kNotConnected, 1}});
}

TEST_CASE("crossed diagonals are named once, unless a flat simplex has them") {
  const std::vector<Point> points = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                     {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Simplex> halves = {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 3, 5}, {1, 2, 3, 5}};
  CHECK(broken({points, halves}) == Tallies{{Rule::kFacesCross, 1}});
  const Verdict verdict = judge_complex({points, halves}, {}, false, 0);
  const Witness& witness = verdict.violations().front().witness;
  CHECK(witness.face == Simplex{0, 2});
  CHECK(witness.vertices == std::vector<Vertex>{1, 3});
  CHECK(witness.point == Point{0, 0, 0});
  CHECK(verdict.complex->crossed_quadrilaterals == 1);
  // Only if all four of its triangles are there.
  for (std::size_t s = 0; s < halves.size(); ++s) {
    std::vector<Simplex> fewer = halves;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(s));
    CHECK(broken({points, fewer}) == Tallies{{Rule::kFacesCross, 1}});
    CHECK(judge_complex({points, fewer}, {}, false, 0).complex->crossed_quadrilaterals == 0);
  }
  halves.push_back({0, 1, 2, 3});
  CHECK(broken({points, halves}) == Tallies{{Rule::kDegenerateSimplex, 1}});
}

TEST_CASE("each edge of a surface that has a border is named if it is to be closed") {
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  std::vector<Simplex> faces = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  CHECK(broken({points, faces}, {.closed = true}).empty());
  faces.pop_back();
  CHECK(broken({points, faces}).empty());
  CHECK(broken({points, faces}, {.closed = true}) == Tallies{{Rule::kNotClosed, 3}});
}

TEST_CASE("a simplex of another size is named with both sizes") {
  const Verdict verdict =
      judge_complex({{{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}, {0, 1}}}, {}, false, 0);
  REQUIRE(verdict.violations().size() == 1);
  const Witness& witness = verdict.violations().front().witness;
  REQUIRE(witness.values.size() == 2);
  CHECK(witness.values[0].value == 2);
  CHECK(witness.values[1].value == 3);
}

TEST_CASE("demands that make no sense of a mesh are said") {
  CHECK(fault_of_demands({.manifold = true}, 4, 3).empty());
  CHECK(fault_of_demands({.manifold = true}, 5, 4)
            .find("for --manifold, found simplices of dimension 4") != std::string::npos);
  const Mesh ragged = in_rows({PointSet({{0, 0}, {4, 0}, {0, 4}}), {{}, {0, 1, 2}, {0, 1}}});
  CHECK(fault_of_demands(ragged, {.closed = true}).find("--closed") != std::string::npos);
  CHECK(fault_of_demands(ragged, {.manifold = true}).empty());
  CHECK(fault_of_demands({}, 3, 2).empty());
  CHECK(fault_of_demands({}, 0, 2).find("found none") != std::string::npos);
  CHECK(fault_of_demands({.oriented = Orientations::kPositive}, 3, 3).find("--oriented=same") !=
        std::string::npos);
  CHECK(fault_of_demands({.closed = true}, 4, 3).find("--closed") != std::string::npos);
  CHECK(fault_of_demands({.manifold = true, .closed = true}, 3, 3).empty());
}

}  // namespace
}  // namespace circumspect::check
