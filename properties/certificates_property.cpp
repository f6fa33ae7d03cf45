// What proves a verdict proves it: certificates and refutations of random meshes, valid and broken,
// by the conditions of proofs/CERTIFICATE.md.
#include <doctest/doctest.h>

#include "oracle/certificate/accepted_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/mutations/mutations.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;

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
  const Verdict verdict =
      check::judge_exactly(claim, mesh, nullptr, {.by = by, .max_violations = 5});
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
