#include "oracle/judge/points/delaunay.hpp"

#include "oracle/judge/points/ball_witness.hpp"
#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

// Let W be a simplex and q, strictly below its witness plane, and let only vertex v of the simplex
// have a positive barycentric coordinate of q. Then v lies in the simplex of all the others, and v⁺
// strictly above its witness plane: the flip that makes the facet locally Delaunay deletes v. Of
// points on the paraboloid itself that is impossible. Book: Section 4.4 ("one of the two
// triangulations might omit a vertex of W").
std::optional<Vertex> submerged_vertex(const PointSet& points, const Simplex& simplex, Vertex q) {
  if (!points.is_weighted()) return std::nullopt;
  const int own = orientation(points.configuration(), simplex);
  std::optional<Vertex> only;
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const Simplex replaced = with_vertex_replaced(simplex, place, q);
    if (orientation(points.configuration(), replaced) * own <= 0) continue;
    if (only) return std::nullopt;
    only = simplex[place];
  }
  return only;
}

void add_facet(const ExactMesh& mesh, const SharedFacet& shared, Verdict& verdict) {
  const Simplex& simplex = mesh.simplices[shared.simplex];
  const Vertex apex = shared.apex;
  const auto submerged = submerged_vertex(mesh.points, simplex, apex);
  if (!submerged) {
    add_in_ball(mesh, Rule::kFacetNotLocal, simplex, shared.facet, apex, verdict);
    return;
  }
  Simplex around = simplex;
  for (Vertex& v : around) v = v == *submerged ? apex : v;
  const Ball ball = circumball(mesh.points, around);
  verdict.add(Rule::kVertexSubmerged,
              {.simplices = {around},
               .vertices = {*submerged},
               .values = {{"height of the lifted vertex above the witness plane",
                           power(mesh.points, ball, *submerged)}},
               .ball = ball});
}

}  // namespace

int judge_facet_locally_delaunay(const ExactMesh& mesh, const SharedFacet& shared,
                                 Verdict& verdict) {
  const Simplex& simplex = mesh.simplices[shared.simplex];
  const int side = in_ball(mesh.points.configuration(), simplex, shared.apex);
  if (side > 0) add_facet(mesh, shared, verdict);
  return side;
}

void judge_facets_locally_delaunay(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                   Verdict& verdict, Ambiguity& ambiguity) {
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    if (group.size() != 2) return;
    const Vertex apex = mesh.simplices[group[1].simplex][group[1].opposite];
    const SharedFacet shared{group[0].facet, group[0].simplex, apex};
    const int side = judge_facet_locally_delaunay(mesh, shared, verdict);
    ambiguity.see(mesh.points, mesh.simplices[shared.simplex], apex, side);
  });
}

void judge_balls_empty(const ExactMesh& mesh, Verdict& verdict, Ambiguity& ambiguity) {
  const Rule rule = mesh.points.is_weighted() ? Rule::kPointBelowPlane : Rule::kVertexInBall;
  for (const Simplex& simplex : mesh.simplices) {
    for (Vertex q = 0; mesh.points.names(q); ++q) {
      if (contains(simplex, q)) continue;
      const int side = in_ball(mesh.points.configuration(), simplex, q);
      ambiguity.see(mesh.points, simplex, q, side);
      if (side > 0) add_in_ball(mesh, rule, simplex, std::nullopt, q, verdict);
    }
  }
}

}  // namespace circumspect::check
