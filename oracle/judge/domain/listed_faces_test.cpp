// Listed edges and triangles, each by itself, by lemma and by definition.
#include "oracle/judge/domain/listed_faces.hpp"

#include <map>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"

namespace circumspect::check {
namespace {

TEST_CASE("listed faces of any size and with any indices break the rules of the definition") {
  std::map<Rule, int> seen;
  int sound = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    generators::Dice dice(seed);
    const std::size_t d = 2 + dice.below(2);
    ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 2}}), {}};
    if (d == 3) mesh.points = PointSet({{0, 0, 0}, {0, 0, 1}, {0, 0, 3}, {0, 1, 0}, {1, 0, 0}});
    mesh.faces.emplace_back(dice.below(6));
    for (Vertex& v : mesh.faces.front()) v = dice.below(9) == 0 ? -1 : dice.within(0L, 5L);
    Verdict by_lemma(Claim::kTriangulation, 0), by_definition(Claim::kTriangulation, 0);
    const bool is_sound = judge_listed_faces(mesh, d, by_lemma);
    CHECK(definition::judge_each_face(mesh, d, by_definition) == is_sound);
    CHECK(by_lemma.holds() == is_sound);
    sound += is_sound ? 1 : 0;
    REQUIRE(by_lemma.violations().size() == by_definition.violations().size());
    if (is_sound) continue;
    const Violation &one = by_lemma.violations()[0], &other = by_definition.violations()[0];
    CHECK(one.rule == other.rule);
    CHECK(one.witness.vertices == other.witness.vertices);
    ++seen[one.rule];
  }
  CHECK(sound > 50);
  CHECK(seen.size() == 4);
}

TEST_CASE("two edges that pass over vertices are two faults, though they have an end in common") {
  PiecewiseLinearInput triangle;
  triangle.points = {{0, 0}, {4, 0}, {2, 4}};
  triangle.segments = {{0, 1}, {1, 2}, {0, 2}};
  const PointSet five({{0, 0}, {4, 0}, {2, 4}, {1, 2}, {3, 2}});
  const ExactMesh whole{five, {{0, 1, 2}}, {}, 0, {}, {{0, 3}, {2, 3}, {1, 4}, {2, 4}}};
  const Verdict verdict = judge_domain(Claim::kSteinerTriangulation, whole, domain_of(triangle));
  CHECK(verdict.tallies().at(Rule::kVertexInEdge).count == 2);
}

}  // namespace
}  // namespace circumspect::check
