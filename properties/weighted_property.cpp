// D10: weighted Delaunay triangulations. Book: Section 4.3 ("the optimal triangulation is a
// weighted Delaunay triangulation"), Section 5.2 (weights).
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

PointSet weighted_set(std::size_t d, std::size_t max_points) {
  const auto sets = generators::any_point_set(d, max_points);
  const generators::PointsCase set = *generators::weighted(sets);
  RC_PRE(set.points.size() >= 2);
  return PointSet(set.points, set.weights);
}

// The common answer by lemma and by definition.
Verdict judged(const ExactMesh& mesh) {
  const Verdict by_lemma = check::judge_points(Claim::kWeightedDelaunay, mesh);
  const Verdict by_definition =
      check::judge_exactly(Claim::kWeightedDelaunay, mesh, nullptr, {.by = check::By::kDefinition});
  RC_ASSERT(by_lemma.holds() == by_definition.holds());
  RC_ASSERT(by_lemma.unique == by_definition.unique);
  RC_ASSERT(by_lemma.canonical == by_definition.canonical);
  return by_lemma;
}

TEST_CASE("D10 the weighted Delaunay triangulation is accepted, as the canonical one") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    std::size_t with_submerged_points = 0;
    CHECK(holds("accepted", 150, [&] {
      const PointSet points = weighted_set(d, 10);
      const ExactMesh mesh{points, delaunay::bowyer_watson(points).simplices()};
      const Verdict verdict = judged(mesh);
      RC_ASSERT(verdict.holds());
      RC_ASSERT(verdict.canonical == true);
      with_submerged_points += check::judge_points(Claim::kTriangulation, mesh).holds() ? 0u : 1u;
    }));
    CHECK(occurs(with_submerged_points));
  }
}

TEST_CASE("D10 lemma and definition agree on altered weighted meshes, valid or not") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    std::size_t rejected = 0;
    std::size_t accepted = 0;
    CHECK(holds("both ways agree", 400, [&] {
      const PointSet points = weighted_set(d, 10);
      const Simplices good = delaunay::bowyer_watson(points).simplices();
      const Mutant mutant =
          *rc::gen::oneOf(alteration(good, points.size()), corruption(good, points.size()));
      ++(judged({points, mutant.simplices}).holds() ? accepted : rejected);
    }));
    CHECK(occurs(rejected));
    if (d > 1) CHECK(occurs(accepted));
  }
}

TEST_CASE("D10 the Delaunay triangulation of the same points without weights is judged alike") {
  CHECK(holds("both ways agree", 300, [] {
    const PointSet points = weighted_set(*rc::gen::element<std::size_t>(2, 3), 10);
    const Triangulation unweighted = delaunay::bowyer_watson(PointSet(points.points()));
    judged({points, unweighted.simplices()});
  }));
}

TEST_CASE("D10 equal weights change nothing") {
  CHECK(holds("equal weights", 200, [] {
    const std::size_t d = *rc::gen::element<std::size_t>(1, 2, 3);
    const auto set = *generators::unweighted(generators::any_point_set(d, 9));
    const Rational weight(*rc::gen::inRange(-3, 4));
    const PointSet points(set.points, std::vector<Rational>(set.points.size(), weight));
    RC_ASSERT(delaunay::bowyer_watson(points) == delaunay::by_definition(PointSet(set.points)));
  }));
}

}  // namespace
}  // namespace circumspect::properties
