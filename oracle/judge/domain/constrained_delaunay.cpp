#include "oracle/judge/domain/constrained_delaunay.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "oracle/judge/domain/facets_of_interest.hpp"
#include "oracle/judge/domain/listed_faces.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::check {

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
  for (const auto group : ByFacet(in.uses)) {
    const Simplex& facet = group.front().facet;
    while (piece != pieces.end() && piece->facet < facet) ++piece;
    if (group.size() != 2 || (piece != pieces.end() && piece->facet == facet)) continue;
    const Simplex& simplex = in.mesh.simplices[group[0].simplex];
    const Vertex apex = in.mesh.simplices[group[1].simplex][group[1].opposite];
    const int side = in_ball(points, simplex, apex);
    if (side == 0) ties.see(points, points.axes(), simplex, apex);
    if (side > 0) {
      add_vertex_in_ball(in.mesh.points, Rule::kConstrainedFacetNotLocal, simplex, facet, apex,
                         verdict);
    }
  }
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
  for (const auto group : ByFacet(facet_uses(triangles))) {
    const Simplex& edge = group.front().facet;
    if (group.size() != 2 || in.chains.is_link(edge[0], edge[1])) continue;
    const Simplex& triangle = triangles[group[0].simplex];
    const Vertex apex = triangles[group[1].simplex][group[1].opposite];
    const std::vector<std::size_t>& axes = in.complex.polygons[polygon[group[0].simplex]].axes;
    const int side = in_ball(points, axes, triangle, apex);
    if (side == 0) ties.see(points, axes, triangle, apex);
    if (side <= 0) continue;
    add_vertex_in_ball(in.mesh.points, Rule::kDanglingNotDelaunay, triangle, edge, apex, verdict);
  }
}

}  // namespace

void judge_constrained_delaunay_by_lemma(const MeshedDomain& in,
                                         const std::vector<WallPiece>& pieces, Verdict& verdict) {
  Ties ties;
  judge_facets(in, pieces, ties, verdict);
  judge_dangling_triangles(in, pieces, ties, verdict);
  ties.conclude(verdict);
}

}  // namespace circumspect::check
