// The claim `surface-delaunay`: by lemma and by definition the same is said, word for word, of
// triangles in the plane and in space; and of triangulations of the plane it is the claim
// `delaunay`. Proof: docs/theory/questions.md.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "oracle/judge/definition/complex.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"
#include "oracle/judge/definition/surface_delaunay.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/surface/judge_surface.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties::surface {
namespace {

using generators::Dice;

// Few coordinates, so that angles have a sum of 180 degrees exactly.
PointSet small_points(Dice& dice, std::size_t d) {
  std::set<Point> points;
  const std::size_t count = d + 1 + dice.below(6);
  while (points.size() < count) {
    Point point;
    for (std::size_t axis = 0; axis < d; ++axis) point.push_back(dice.within(0L, 4L));
    points.insert(point);
  }
  return PointSet({points.begin(), points.end()});
}

// Triangles of a triangulation: in the plane all, in space those of its boundary or some of all.
ExactMesh drawn_surface(Dice& dice, std::size_t d) {
  ExactMesh mesh{small_points(dice, d), {}};
  const std::vector<Simplex> simplices = delaunay::bowyer_watson(mesh.points).simplices();
  mesh.simplices = d == 2               ? simplices
                   : dice.below(3) != 0 ? definition::open_facets(simplices)
                                        : faces_of(simplices, 3);
  std::erase_if(mesh.simplices, [](const Simplex& simplex) { return simplex.size() != 3; });
  return mesh;
}

// An interior edge becomes the other diagonal, or a corner another point.
void break_once(Dice& dice, ExactMesh& mesh) {
  if (mesh.simplices.empty()) return;
  const std::vector<definition::InteriorEdge> edges =
      definition::surface_edges(mesh.simplices).interior;
  if (!edges.empty() && dice.below(4) != 0) {
    const definition::InteriorEdge& edge = edges[dice.below(edges.size())];
    mesh.simplices[edge.first] = {edge.of_first, edge.of_second, edge.edge[0]};
    mesh.simplices[edge.second] = {edge.of_second, edge.of_first, edge.edge[1]};
    return;
  }
  Simplex& triangle = mesh.simplices[dice.below(mesh.simplices.size())];
  triangle[dice.below(3)] = static_cast<Vertex>(dice.below(mesh.points.size() + 1));
}

bool has_repeated(const std::vector<Simplex>& simplices) {
  return std::any_of(simplices.begin(), simplices.end(), has_repeated_vertex);
}

std::string text(const Verdict& verdict, const Mesh& mesh) {
  return report::explanation(verdict, mesh) + report::verdict_line(verdict, mesh, "m") +
         std::to_string(verdict.surface->interior_edges) + " " +
         std::to_string(verdict.surface->boundary_edges) + " " +
         std::to_string(verdict.surface->edges_of_many);
}

// However few witnesses are kept.
std::map<Rule, std::size_t> counts(const Verdict& verdict) {
  std::map<Rule, std::size_t> counts;
  for (const auto& [rule, tally] : verdict.tallies()) counts[rule] = tally.count;
  return counts;
}

struct Outcomes {
  std::map<Rule, std::size_t> broken = {};
  std::size_t held = 0, with_edges_of_many = 0;
};

void compare(std::size_t d, int inputs, Outcomes& seen) {
  CHECK(holds("by lemma as by definition, and as by the judge of arrays", inputs, [&, d] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    ExactMesh mesh = drawn_surface(dice, d);
    for (std::size_t faults = dice.below(3); faults > 0; --faults) {
      if (!has_repeated(mesh.simplices)) break_once(dice, mesh);
    }
    const Verdict by_lemma = check::judge_surface(mesh, false, 0);
    const Mesh rows = in_rows(mesh);
    RC_ASSERT(text(by_lemma, rows) == text(check::judge_surface(mesh, true, 0), rows));
    const Verdict of_arrays =
        check::judge(Claim::kSurfaceDelaunay, rows, nullptr, {.max_violations = 0}).value();
    RC_ASSERT(text(of_arrays, rows) == text(by_lemma, rows));
    RC_ASSERT(counts(check::judge_surface(mesh, false, 1)) == counts(by_lemma));
    seen.held += by_lemma.holds() ? 1 : 0;
    seen.with_edges_of_many += by_lemma.surface->edges_of_many > 0 ? 1 : 0;
    for (const auto& [rule, tally] : by_lemma.tallies()) ++seen.broken[rule];
    const auto holds_by_definition = [&](Claim claim) {
      const check::Options plain{.by = check::By::kDefinition, .max_violations = 0};
      return check::judge_exactly(claim, mesh, nullptr, plain).holds();
    };
    if (d == 2 && holds_by_definition(Claim::kTriangulation)) {
      RC_ASSERT(by_lemma.holds() == holds_by_definition(Claim::kDelaunay));
    }
  }));
}

TEST_CASE("surface-delaunay: by lemma and by definition the same is said of all triangles") {
  Outcomes seen;
  compare(2, 5000, seen);
  compare(3, 5000, seen);
  CHECK(occurs(seen.held, 1000));
  CHECK(occurs(seen.with_edges_of_many, 100));
  for (const Rule rule : {Rule::kEdgeNotDelaunay, Rule::kDegenerateSimplex, Rule::kUnknownVertex,
                          Rule::kRepeatedVertex, Rule::kDuplicateSimplex}) {
    CAPTURE(identifier(rule));
    CHECK(occurs(seen.broken[rule]));
  }
}

}  // namespace
}  // namespace circumspect::properties::surface
