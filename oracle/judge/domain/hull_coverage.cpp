// Coverage where the convex hull is the domain: what docs/theory/points.md proves of triangulations
// of point sets does most of the work.
#include <algorithm>
#include <map>
#include <set>

#include "oracle/judge/domain/coverage.hpp"
#include "oracle/judge/domain/listed_faces.hpp"
#include "oracle/judge/domain/outside_simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {

namespace {

// A vertex on the boundary of a convex polyhedron is extreme iff its boundary facets lie in three
// planes or more; on the boundary of a convex polygon, in two lines. So count the planes up to
// that.
void judge_hull_unchanged(const MeshedDomain& in, Verdict& verdict) {
  const std::vector<BoundaryFacet> boundary = boundary_facets(in.mesh, in.uses);
  std::map<Vertex, std::vector<std::size_t>> facets_at;
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    for (const Vertex v : boundary[f].facet) {
      if (in.places.is_steiner(v)) facets_at[v].push_back(f);
    }
  }
  const Configuration& points = in.mesh.points.configuration();
  const auto coplanar = [&](std::size_t a, std::size_t b) {
    const Simplex& other = boundary[b].facet;
    return std::all_of(other.begin(), other.end(),
                       [&](Vertex v) { return side_of(points, boundary[a], v) == 0; });
  };
  std::set<Vertex> extreme;
  for (const auto& [v, facets] : facets_at) {
    std::vector<std::size_t> planes;
    for (const std::size_t f : facets) {
      const bool seen = std::any_of(planes.begin(), planes.end(),
                                    [&](std::size_t plane) { return coplanar(plane, f); });
      if (!seen) planes.push_back(f);
      if (planes.size() >= in.complex.ambient_dimension()) break;
    }
    if (planes.size() == in.complex.ambient_dimension()) extreme.insert(v);
  }
  OutsideSimplices outside(in);
  for (std::size_t s = 0; s < in.mesh.simplices.size() && !extreme.empty(); ++s) {
    std::vector<Vertex> vertices;
    for (const Vertex v : in.mesh.simplices[s]) {
      if (extreme.contains(v)) vertices.push_back(v);
    }
    if (!vertices.empty()) outside.add(s, {.vertices = vertices}, verdict);
  }
}

}  // namespace

void judge_hull_coverage(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                         Verdict& verdict) {
  if (in.mesh.simplices.empty()) {
    verdict.add(Rule::kUncovered, {.point = barycentre(in.complex.points.points())});
    return;
  }
  if (in.known == nullptr || !in.known->fills_hull) {
    const std::size_t faults = verdict.tallies().size();
    judge_complex_by_lemma(in.mesh, facet_uses(in.mesh.simplices), verdict);
    if (verdict.tallies().size() > faults) return;
  }
  judge_hull_unchanged(in, verdict);
  for (const WallPiece& piece : pieces) {
    if (is_facet(in.uses, piece.facet)) continue;
    verdict.add(Rule::kUncovered, {.face = piece.facet});
  }
}

}  // namespace circumspect::check
