// The checkers of triangulations of points, weighted or not, and their certificates.
#include <sstream>

#include <doctest/doctest.h>

#include "oracle/certificate/accepted_test.hpp"
#include "oracle/judge/points/check.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/mutations/mutations.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

// ---- checkers ----
// The two ways to judge a claim are one: by lemma and by definition, on valid and on broken meshes.
// Book: Definition 2.1, Definition 4.1, Lemma 4.1; proof: docs/theory/points.md.

using generators::PointsCase;

// A set with a simplex to break: of dimension at least 1.
PointSet breakable_set(std::size_t d, std::size_t max_points) {
  const PointsCase set = *generators::unweighted(generators::any_point_set(d, max_points));
  RC_PRE(set.points.size() >= 2);
  return PointSet(set.points);
}

bool holds_by(check::By by, Claim claim, const ExactMesh& mesh) {
  return check::judge_points(claim, mesh, {.by = by}).holds();
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
      const Verdict by_lemma = check::delaunay(mesh, {.by = check::By::kLemma});
      const Verdict by_definition = check::delaunay(mesh, {.by = check::By::kDefinition});
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

// ---- weighted ----
// D10: weighted Delaunay triangulations. Book: Section 4.3 ("the optimal triangulation is a
// weighted Delaunay triangulation"), Section 5.2 (weights).

PointSet weighted_set(std::size_t d, std::size_t max_points) {
  const auto sets = generators::any_point_set(d, max_points);
  const generators::PointsCase set = *generators::weighted(sets);
  RC_PRE(set.points.size() >= 2);
  return PointSet(set.points, set.weights);
}

// The common answer by lemma and by definition.
Verdict judged(const ExactMesh& mesh) {
  const Verdict by_lemma = check::weighted_delaunay(mesh, {.by = check::By::kLemma});
  const Verdict by_definition = check::weighted_delaunay(mesh, {.by = check::By::kDefinition});
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
      with_submerged_points += check::triangulation(mesh).holds() ? 0u : 1u;
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

// ---- certificates ----
// What proves a verdict proves it: certificates and refutations of random meshes, valid and broken,
// by the conditions of proofs/CERTIFICATE.md.

// A set that spans its space.
PointSet spanning_set(std::size_t d, std::size_t max_points, bool weighted) {
  const auto sets = generators::any_point_set(d, max_points);
  const PointsCase set = weighted ? *generators::weighted(sets) : *generators::unweighted(sets);
  const PointSet points(set.points, set.weights);
  RC_PRE(points.dimension() == static_cast<int>(d));
  return points;
}

// Is the verdict proved? Counts both kinds.
void prove(Claim claim, const ExactMesh& mesh, check::By by, std::size_t& held,
           std::size_t& failed) {
  const Verdict verdict = check::judge_points(claim, mesh, {.by = by, .max_violations = 5});
  RC_ASSERT(certificate::fault_of(mesh, verdict) == "");
  ++(verdict.holds() ? held : failed);
}

check::By any_way() {
  return *rc::gen::element(check::By::kLemma, check::By::kLemma, check::By::kDefinition);
}

TEST_CASE("each verdict on a Delaunay triangulation, or an altered one, is proved") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    std::size_t held = 0;
    std::size_t failed = 0;
    CHECK(holds("proved", 600, [&] {
      const PointSet points = spanning_set(d, 10, false);
      Simplices simplices = delaunay::bowyer_watson(points).simplices();
      const int kind = *rc::gen::inRange(0, 4);
      if (kind == 1) simplices = (*corruption(simplices, points.size())).simplices;
      if (kind > 1) simplices = (*alteration(simplices, points.size())).simplices;
      const ExactMesh mesh{points, simplices};
      const Claim claim = *rc::gen::element(Claim::kTriangulation, Claim::kDelaunay);
      prove(claim, mesh, any_way(), held, failed);
    }));
    CHECK(occurs(held));
    CHECK(occurs(failed));
  }
}

TEST_CASE("each verdict on a weighted Delaunay triangulation, or an altered one, is proved") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    std::size_t held = 0;
    std::size_t failed = 0;
    CHECK(holds("proved", 400, [&] {
      const PointSet points = spanning_set(d, 10, true);
      // That of the points without weights is broken by weighted rules.
      const bool right = *rc::gen::arbitrary<bool>();
      Simplices simplices =
          delaunay::bowyer_watson(right ? points : PointSet(points.points())).simplices();
      if (*rc::gen::inRange(0, 3) == 0) {
        simplices = (*alteration(simplices, points.size())).simplices;
      }
      prove(Claim::kWeightedDelaunay, {points, simplices}, any_way(), held, failed);
    }));
    CHECK(occurs(held));
    CHECK(occurs(failed));
  }
}

}  // namespace

}  // namespace circumspect::properties
