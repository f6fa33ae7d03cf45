// Meshes as arrays of doubles: what `judge` says of them, mostly by the fast judge where they hold,
// is word for word what the checkers say. Proof: docs/theory/fast.md.
#include <string>

#include <circumspect/check.hpp>
#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "oracle/judge/arrays/arrays_of_test.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/mutations/mutations.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

using arrays::MeshInArrays;

// How often each kind of answer came up.
struct Answers {
  std::size_t fast = 0;      // the claim holds, and the fast judge said so
  std::size_t slow = 0;      // it holds, and oracle/judge/points said so
  std::size_t rejected = 0;  // it does not
  std::size_t wrong_neighbors = 0;
};

void judge_and_compare(Claim claim, const ExactMesh& mesh, Answers& answers) {
  const auto arrays = arrays::arrays_of(mesh);
  if (!arrays) return;
  const unsigned threads = *rc::gen::element(1U, 2U);
  const MeshJudgement judgement =
      judge(std::string(name(claim)), arrays->view(), {.threads = threads});
  RC_ASSERT(arrays::difference_from_slow(claim, mesh, judgement) == "");
  ++(!judgement.holds ? answers.rejected : judgement.counts.fast ? answers.fast : answers.slow);
  if (judgement.rule == "complex.wrong-neighbor") ++answers.wrong_neighbors;
}

// Sets of doubles that span their space. Weighted, if the claim is.
PointSet set_of_doubles(std::size_t d, bool weighted) {
  const auto cases =
      weighted ? generators::any_case(d, 12) : generators::any_unweighted_case(d, 12);
  const generators::PointsCase set = generators::in_doubles(*cases);
  const PointSet points(set.points, set.weights);
  RC_PRE(points.dimension() == static_cast<int>(d));
  return points;
}

TEST_CASE("Delaunay triangulations hold, and the fast judge decides") {
  for (const std::size_t d : {2u, 3u}) {
    Answers answers;
    CHECK(holds("of sets of doubles", 400, [&] {
      const bool weighted = *rc::gen::arbitrary<bool>();
      const PointSet points = set_of_doubles(d, weighted);
      const ExactMesh mesh{points, delaunay::bowyer_watson(points).simplices()};
      const Claim claim = points.is_weighted() ? Claim::kWeightedDelaunay : Claim::kDelaunay;
      judge_and_compare(claim, mesh, answers);
    }));
    CAPTURE(d);
    CAPTURE(answers.slow);
    CHECK(answers.rejected == 0);
    // Sets that span a few ulps may have no double inside a simplex.
    CHECK(occurs(answers.fast, 30 * (answers.slow + 1)));
  }
}

TEST_CASE("of mutated meshes, both judges say the same") {
  for (const std::size_t d : {2u, 3u}) {
    for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
      Answers answers;
      CHECK(holds("of sets of doubles", 300, [&] {
        const PointSet points = set_of_doubles(d, claim == Claim::kWeightedDelaunay);
        const Simplices good = delaunay::bowyer_watson(points).simplices();
        const Mutant mutant =
            *rc::gen::oneOf(corruption(good, points.size()), alteration(good, points.size()),
                            alteration(good, points.size()));
        judge_and_compare(claim, {points, mutant.simplices}, answers);
      }));
      CAPTURE(d);
      CAPTURE(name(claim));
      CHECK(occurs(answers.fast));
      CHECK(occurs(answers.rejected));
    }
  }
}

// The true neighbours of each simplex.
Neighbors neighbors_of(const Simplices& simplices) {
  Neighbors neighbors;
  for (const Simplex& simplex : simplices) neighbors.rows.emplace_back(simplex.size(), -1);
  for (const auto group : ByFacet(facet_uses(simplices))) {
    if (group.size() != 2) continue;
    neighbors.rows[group[0].simplex][group[0].opposite] = static_cast<Vertex>(group[1].simplex);
    neighbors.rows[group[1].simplex][group[1].opposite] = static_cast<Vertex>(group[0].simplex);
  }
  return neighbors;
}

// Another entry at one end of a link, or two links crossed at all their ends.
void break_links(Neighbors& neighbors) {
  const auto size = static_cast<Vertex>(neighbors.rows.size());
  const auto any_entry = [&]() -> Vertex& {
    auto& row = neighbors.rows[static_cast<std::size_t>(*rc::gen::inRange<Vertex>(0, size))];
    return row[*rc::gen::inRange<std::size_t>(0, row.size())];
  };
  const auto end_of = [&](Vertex from, Vertex to) -> Vertex& {
    auto& row = neighbors.rows[static_cast<std::size_t>(from)];
    return *std::find(row.begin(), row.end(), to);
  };
  if (*rc::gen::arbitrary<bool>()) {
    any_entry() = *rc::gen::inRange<Vertex>(-1, size + 1);
    return;
  }
  const Vertex a = *rc::gen::inRange<Vertex>(0, size), b = *rc::gen::inRange<Vertex>(0, size);
  const Vertex across_a = *rc::gen::elementOf(neighbors.rows[static_cast<std::size_t>(a)]);
  const Vertex across_b = *rc::gen::elementOf(neighbors.rows[static_cast<std::size_t>(b)]);
  std::swap(end_of(a, across_a), end_of(b, across_b));
  if (across_a < 0 || across_b < 0 || a == b || across_a == across_b) return;
  if (across_a == b || across_b == a) return;
  std::swap(end_of(across_a, a), end_of(across_b, b));
}

TEST_CASE("of listed neighbours, right and wrong at one end or at both, both judges say the same") {
  for (const std::size_t d : {2u, 3u}) {
    Answers answers;
    CHECK(holds("of sets of doubles", 600, [&] {
      const PointSet points = set_of_doubles(d, false);
      Simplices simplices = delaunay::bowyer_watson(points).simplices();
      if (*rc::gen::inRange(0, 3) == 0) {
        simplices = (*alteration(simplices, points.size())).simplices;
      }
      ExactMesh mesh{points, simplices};
      mesh.neighbors = neighbors_of(simplices);
      if (!simplices.empty() && *rc::gen::inRange(0, 3) > 0) break_links(*mesh.neighbors);
      judge_and_compare(Claim::kTriangulation, mesh, answers);
    }));
    CAPTURE(d);
    CHECK(occurs(answers.fast));
    CHECK(occurs(answers.wrong_neighbors));
  }
}

}  // namespace
}  // namespace circumspect::properties
