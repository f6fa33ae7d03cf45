#include "oracle/check/delaunay.hpp"

#include "reference/complex/circumball.hpp"
#include "reference/complex/facets.hpp"
#include "reference/predicates/in_ball.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect::check {
namespace {

// What the empty balls say about other Delaunay triangulations of the same points.
struct Ambiguity {
  bool unique = true;
  bool canonical = true;

  // A point on the sphere of an empty ball makes a cell with more than k+1 vertices, which has more
  // than one triangulation; the canonical one has empty balls under the perturbation too.
  void see(const PointSet& points, const Simplex& simplex, Vertex q, int side) {
    if (side != 0) return;
    unique = false;
    if (canonical) canonical = perturbed_in_ball(points.configuration(), simplex, q) < 0;
  }
};

// q lies strictly inside the circumball of the simplex: the witness, and how deep relative to r².
void report(const Mesh& mesh, Rule rule, const Simplex& simplex, std::optional<Simplex> facet,
            Vertex q, Verdict& verdict) {
  const Ball ball = circumball(mesh.points, simplex);
  const Rational distance = squared_distance(mesh.points[q], ball.centre);
  const Rational margin = 1 - distance / ball.squared_radius;
  verdict.add(rule,
              {.simplices = {simplex},
               .face = std::move(facet),
               .vertices = {q},
               .values = {{"squared distance from centre", distance},
                          {"squared radius", ball.squared_radius},
                          {"squared radius less squared distance", ball.squared_radius - distance}},
               .ball = ball},
              margin);
}

void conclude(const Ambiguity& ambiguity, Verdict& verdict) {
  if (!verdict.holds()) return;
  verdict.unique = ambiguity.unique;
  verdict.canonical = ambiguity.canonical;
}

}  // namespace

void judge_facets_locally_delaunay(const Mesh& mesh, Verdict& verdict) {
  Ambiguity ambiguity;
  for_each_facet(facet_uses(mesh.simplices), [&](std::span<const FacetUse> group) {
    if (group.size() != 2) return;
    const Simplex& simplex = mesh.simplices[group[0].simplex];
    const Vertex apex = mesh.simplices[group[1].simplex][group[1].opposite];
    const int side = in_ball(mesh.points.configuration(), simplex, apex);
    ambiguity.see(mesh.points, simplex, apex, side);
    if (side > 0) {
      report(mesh, Rule::kFacetNotLocal, simplex, group[0].facet, apex, verdict);
    }
  });
  conclude(ambiguity, verdict);
}

void judge_balls_empty(const Mesh& mesh, Verdict& verdict) {
  Ambiguity ambiguity;
  for (const Simplex& simplex : mesh.simplices) {
    for (Vertex q = 0; mesh.points.names(q); ++q) {
      if (contains(simplex, q)) continue;
      const int side = in_ball(mesh.points.configuration(), simplex, q);
      ambiguity.see(mesh.points, simplex, q, side);
      if (side > 0) report(mesh, Rule::kVertexInBall, simplex, std::nullopt, q, verdict);
    }
  }
  conclude(ambiguity, verdict);
}

}  // namespace circumspect::check
