#include "oracle/judge/domain/constrained_delaunay.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "oracle/judge/domain/empty_circumball.hpp"
#include "oracle/judge/domain/listed_faces.hpp"
#include "oracle/judge/domain/measures.hpp"
#include "oracle/judge/points/delaunay.hpp"

namespace circumspect::check {

// ---- Constrained Delaunay by lemma ----

namespace {

// What ties say about other constrained Delaunay triangulations. Without ties there is no other
// (Proposition 4.12). In a plane a tie can be flipped; in space it may be that it cannot.
struct Ties {
  bool any = false;
  bool in_plane = false;
  bool canonical = true;

  void see(const Configuration& points, std::span<const std::size_t> axes, const Simplex& simplex,
           Vertex apex) {
    any = true;
    in_plane |= axes.size() == 2;
    if (canonical) canonical = perturbed_in_ball(points, axes, simplex, apex) < 0;
  }

  // All ties of simplices. Those in walls do not count.
  template <class Counts>
  void see_known(const fast::SimplexFacts& known, std::size_t dimension, const Counts& counts) {
    any = std::any_of(known.ties.begin(), known.ties.end(), counts);
    in_plane = any && dimension == 2;
    canonical = std::none_of(known.not_canonical.begin(), known.not_canonical.end(), counts);
  }

  void conclude(Verdict& verdict) const {
    if (!verdict.holds()) return;
    verdict.canonical = canonical;
    if (!any) verdict.unique = true;
    if (in_plane) verdict.unique = false;
  }
};

void judge_facets(const MeshedDomain& in, const std::vector<WallPiece>& pieces, Ties& ties,
                  Verdict& verdict) {
  if (in.known != nullptr) {
    const auto is_off_walls = [&](fast::FacetId facet) {
      return !is_piece(pieces, vertices_of(in.mesh, facet));
    };
    ties.see_known(*in.known, in.complex.ambient_dimension(), is_off_walls);
    const std::vector<fast::FacetId>& not_local = in.known->not_local;
    if (std::none_of(not_local.begin(), not_local.end(), is_off_walls)) return;
  }
  const Configuration& points = in.mesh.points.configuration();
  auto piece = pieces.begin();
  for_each_facet(in.uses, [&](std::span<const FacetUse> group) {
    const Simplex& facet = group.front().facet;
    while (piece != pieces.end() && piece->facet < facet) ++piece;
    if (group.size() != 2 || (piece != pieces.end() && piece->facet == facet)) return;
    const Simplex& simplex = in.mesh.simplices[group[0].simplex];
    const Vertex apex = in.mesh.simplices[group[1].simplex][group[1].opposite];
    const int side = in_ball(points, simplex, apex);
    if (side == 0) ties.see(points, points.axes(), simplex, apex);
    if (side > 0) {
      add_in_ball(in.mesh, Rule::kConstrainedFacetNotLocal, simplex, facet, apex, verdict);
    }
  });
}

void judge_dangling_triangles(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                              Ties& ties, Verdict& verdict) {
  if (in.complex.ambient_dimension() == 2) return;
  std::vector<Simplex> triangles;
  std::vector<std::size_t> polygon;
  for (const WallPiece& piece : pieces) {
    if (in.is_inside(piece.regions[0]) || in.is_inside(piece.regions[1])) continue;
    if (in.complex.kind == DomainKind::kHull && !in.mesh.simplices.empty()) continue;
    triangles.push_back(piece.facet);
    polygon.push_back(piece.cell);
  }
  const Configuration& points = in.mesh.points.configuration();
  for_each_facet(facet_uses(triangles), [&](std::span<const FacetUse> group) {
    const Simplex& edge = group.front().facet;
    if (group.size() != 2 || in.chains.is_link(edge[0], edge[1])) return;
    const Simplex& triangle = triangles[group[0].simplex];
    const Vertex apex = triangles[group[1].simplex][group[1].opposite];
    const std::vector<std::size_t>& axes = in.complex.polygons[polygon[group[0].simplex]].axes;
    const int side = in_ball(points, axes, triangle, apex);
    if (side == 0) ties.see(points, axes, triangle, apex);
    if (side > 0) add_in_ball(in.mesh, Rule::kDanglingNotDelaunay, triangle, edge, apex, verdict);
  });
}

}  // namespace

void judge_constrained_delaunay_by_lemma(const MeshedDomain& in,
                                         const std::vector<WallPiece>& pieces, Verdict& verdict) {
  Ties ties;
  judge_facets(in, pieces, ties, verdict);
  judge_dangling_triangles(in, pieces, ties, verdict);
  ties.conclude(verdict);
}

// ---- Conforming Delaunay ----

namespace {

void judge_shared_facet(const ExactMesh& mesh, std::span<const FacetUse> group, Verdict& verdict) {
  const Simplex& simplex = mesh.simplices[group[0].simplex];
  const Vertex apex = mesh.simplices[group[1].simplex][group[1].opposite];
  if (in_ball(mesh.points.configuration(), simplex, apex) <= 0) return;
  add_in_ball(mesh, Rule::kFacetNotLocal, simplex, group[0].facet, apex, verdict);
}

void judge_ball_at_boundary(const ExactMesh& mesh, const VertexIndex& index, const FacetUse& use,
                            Verdict& verdict) {
  const Simplex& simplex = mesh.simplices[use.simplex];
  for (const Vertex v : index.near(circumball(mesh.points, simplex))) {
    if (contains(simplex, v) || in_ball(mesh.points.configuration(), simplex, v) <= 0) continue;
    add_in_ball(mesh, Rule::kVertexInBall, simplex, use.facet, v, verdict);
  }
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

}  // namespace

void judge_delaunay_by_lemma(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                             Verdict& verdict) {
  const VertexIndex index(in.mesh.points);
  const bool all_are_local = in.known != nullptr && in.known->not_local.empty();
  const bool are_empty_at_boundary = in.known != nullptr && in.known->boundary_balls_are_empty;
  // A simplex with several facets on the boundary is judged at the first.
  std::vector<bool> judged(in.mesh.simplices.size(), false);
  for_each_facet(in.uses, [&](std::span<const FacetUse> group) {
    if (group.size() == 2) {
      if (!all_are_local) judge_shared_facet(in.mesh, group, verdict);
      return;
    }
    if (are_empty_at_boundary || judged[group.front().simplex]) return;
    judged[group.front().simplex] = true;
    judge_ball_at_boundary(in.mesh, index, group.front(), verdict);
  });
  const auto near = [&](const Ball& ball) { return index.near(ball); };
  for (const Simplex& simplex : dangling_simplices(in, pieces)) {
    judge_dangling(in.mesh, simplex, near, verdict);
  }
}

}  // namespace circumspect::check
