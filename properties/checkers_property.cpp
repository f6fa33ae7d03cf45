// The two ways to judge a claim are one: by lemma and by definition, on valid and on broken meshes.
// Book: Definition 2.1, Definition 4.1, Lemma 4.1; proof: docs/theory/points.md.
#include <doctest/doctest.h>

#include "oracle/certificate/accepted_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/mutations/mutations.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;

// A set with a simplex to break: of dimension at least 1.
PointSet breakable_set(std::size_t d, std::size_t max_points) {
  const PointsCase set = *generators::unweighted(generators::any_point_set(d, max_points));
  RC_PRE(set.points.size() >= 2);
  return PointSet(set.points);
}

bool holds_by(check::By by, Claim claim, const ExactMesh& mesh) {
  return check::judge_exactly(claim, mesh, nullptr, {.by = by}).holds();
}

// The common answer of both ways.
bool judged(Claim claim, const ExactMesh& mesh) {
  const bool by_lemma = holds_by(check::By::kLemma, claim, mesh);
  RC_ASSERT(by_lemma == holds_by(check::By::kDefinition, claim, mesh));
  return by_lemma;
}

TEST_CASE("a corrupted mesh is rejected by lemma and by definition") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("every corruption is rejected", 400, [d] {
      const PointSet points = breakable_set(d, 10);
      const Triangulation good = delaunay::bowyer_watson(points);
      const Mutant mutant = *corruption(good.simplices(), points.size());
      const ExactMesh mesh{points, mutant.simplices};
      RC_ASSERT_FALSE(judged(Claim::kTriangulation, mesh));
      RC_ASSERT_FALSE(judged(Claim::kDelaunay, mesh));
    }));
  }
}

TEST_CASE("lemma and definition agree on altered meshes, valid or not") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    std::size_t triangulations = 0;
    std::size_t delaunay_ones = 0;
    CHECK(holds("both ways agree", 600, [&] {
      const PointSet points = breakable_set(d, 10);
      const Triangulation good = delaunay::bowyer_watson(points);
      const Mutant mutant = *alteration(good.simplices(), points.size());
      const ExactMesh mesh{points, mutant.simplices};
      triangulations += judged(Claim::kTriangulation, mesh) ? 1u : 0u;
      delaunay_ones += judged(Claim::kDelaunay, mesh) ? 1u : 0u;
    }));
    // The property says nothing unless both answers come up.
    CHECK(occurs(triangulations));
    if (d > 1) CHECK(occurs(triangulations - delaunay_ones));
  }
}

TEST_CASE("lemma and definition report the same uniqueness and canonicity") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    std::size_t not_canonical = 0;
    CHECK(holds("same facts", 300, [&] {
      const PointSet points = breakable_set(d, 10);
      const Mutant mutant = *alteration(delaunay::bowyer_watson(points).simplices(), points.size());
      const ExactMesh mesh{points, mutant.simplices};
      check::Options options{.oriented = *rc::gen::inRange(0, 4) == 0};
      const Verdict by_lemma = check::judge_points(Claim::kDelaunay, mesh, options);
      options.by = check::By::kDefinition;
      const Verdict by_definition = check::judge_exactly(Claim::kDelaunay, mesh, nullptr, options);
      RC_ASSERT(by_lemma.holds() == by_definition.holds());
      RC_ASSERT(by_lemma.unique == by_definition.unique);
      RC_ASSERT(by_lemma.canonical == by_definition.canonical);
      not_canonical += by_lemma.canonical == false ? 1u : 0u;
    }));
    CHECK(occurs(not_canonical));
  }
}

// The order of simplices and of their vertices means nothing to a claim.
TEST_CASE("the verdict does not depend on the order of simplices and vertices") {
  CHECK(holds("reversed lists", 200, [] {
    const PointSet points = breakable_set(*rc::gen::element<std::size_t>(2, 3), 9);
    const Mutant mutant = *alteration(delaunay::bowyer_watson(points).simplices(), points.size());
    Simplices reversed(mutant.simplices.rbegin(), mutant.simplices.rend());
    for (Simplex& simplex : reversed) simplex = Simplex(simplex.rbegin(), simplex.rend());
    RC_ASSERT(judged(Claim::kDelaunay, {points, mutant.simplices}) ==
              judged(Claim::kDelaunay, {points, reversed}));
  }));
}

}  // namespace
}  // namespace circumspect::properties
