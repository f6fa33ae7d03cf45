#include "oracle/judge/domain/conforming_delaunay.hpp"

#include <algorithm>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "oracle/judge/domain/empty_circumball.hpp"
#include "oracle/judge/domain/listed_faces.hpp"
#include "oracle/judge/domain/vertex_index.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::check {

namespace {

void judge_shared_facet(const ExactMesh& mesh, std::span<const FacetUse> group, Verdict& verdict) {
  const Simplex& simplex = mesh.simplices[group[0].simplex];
  const Vertex apex = mesh.simplices[group[1].simplex][group[1].opposite];
  if (in_ball(mesh.points.configuration(), simplex, apex) <= 0) return;
  add_vertex_in_ball(mesh.points, Rule::kFacetNotLocal, simplex, group[0].facet, apex, verdict);
}

void judge_dangling(const ExactMesh& mesh, const Simplex& simplex, const VerticesNear& near,
                    Verdict& verdict) {
  const std::vector<Vertex> against = vertices_in_every_circumball(mesh.points, simplex, near);
  if (against.empty()) return;
  verdict.add(
      Rule::kNoEmptyBall,
      {.simplices = {simplex}, .vertices = against, .ball = circumball(mesh.points, simplex)});
}

// The pieces that are facets of no simplex and, in space, the links that no simplex or piece has.
std::vector<Simplex> dangling_simplices(const MeshedDomain& in,
                                        const std::vector<WallPiece>& pieces) {
  std::vector<Simplex> dangling;
  for (const WallPiece& piece : pieces) {
    if (!is_facet(in.uses, piece.facet)) dangling.push_back(piece.facet);
  }
  if (in.complex.ambient_dimension() == 2) return dangling;
  std::vector<Simplex> links;
  for (std::size_t s = 0; s < in.chains.size(); ++s) {
    const std::vector<Vertex>& chain = in.chains.chain(s);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      links.push_back(sorted({chain[i], chain[i + 1]}));
    }
  }
  std::sort(links.begin(), links.end());
  const std::vector<Simplex> strays = edges_of_nothing(in, pieces, links);
  dangling.insert(dangling.end(), strays.begin(), strays.end());
  return dangling;
}

// Of each simplex: need its ball not be looked at, since it is known to be empty?
std::vector<bool> known_to_be_empty(const MeshedDomain& in) {
  const bool is_known = in.known != nullptr && in.known->doubtful_balls;
  std::vector<bool> empty(in.mesh.simplices.size(), is_known);
  if (is_known) {
    for (const std::size_t s : *in.known->doubtful_balls) empty[s] = false;
  }
  return empty;
}

}  // namespace

void judge_ball_at_boundary(const ExactMesh& mesh, const VertexIndex& index, std::size_t simplex,
                            const Simplex& facet, Verdict& verdict) {
  const Simplex& corners = mesh.simplices[simplex];
  for (const Vertex v : index.near(circumball(mesh.points, corners))) {
    if (contains(corners, v) || in_ball(mesh.points.configuration(), corners, v) <= 0) continue;
    add_vertex_in_ball(mesh.points, Rule::kVertexInBall, corners, facet, v, verdict);
  }
}

void judge_delaunay_by_lemma(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                             Verdict& verdict) {
  const VertexIndex index(in.mesh.points);
  const bool all_are_local = in.known != nullptr && in.known->not_local.empty();
  // A simplex with several facets on the boundary is judged at the first.
  std::vector<bool> judged = known_to_be_empty(in);
  for (const auto group : ByFacet(in.uses)) {
    if (group.size() == 2) {
      if (!all_are_local) judge_shared_facet(in.mesh, group, verdict);
      continue;
    }
    if (judged[group.front().simplex]) continue;
    judged[group.front().simplex] = true;
    judge_ball_at_boundary(in.mesh, index, group.front().simplex, group.front().facet, verdict);
  }
  const auto near = [&](const Ball& ball) { return index.near(ball); };
  for (const Simplex& simplex : dangling_simplices(in, pieces)) {
    judge_dangling(in.mesh, simplex, near, verdict);
  }
}

}  // namespace circumspect::check
