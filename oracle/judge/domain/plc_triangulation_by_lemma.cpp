// Conditions 0–7 of docs/theory/domains.md, where it is proved that they suffice.
#include <algorithm>

#include "oracle/judge/domain/coverage.hpp"
#include "oracle/judge/domain/facets_of_interest.hpp"
#include "oracle/judge/domain/listed_faces.hpp"
#include "oracle/judge/domain/plc_triangulation.hpp"
#include "oracle/judge/domain/polygon_tiling.hpp"
#include "oracle/judge/domain/segments.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {
namespace {

// Is the domain the convex hull of its vertices, and has that a volume (in the plane, an area)?
bool is_full_hull(const PiecewiseLinearComplex& complex) {
  return complex.kind == DomainKind::kHull &&
         complex.points.dimension() == static_cast<int>(complex.ambient_dimension());
}

// The linear cells, from the lowest dimension up: those of a higher one only make sense if those of
// the lower ones are right.
void judge_cells(const MeshedDomain& in, const OfTriangulation& then, Verdict& verdict) {
  const bool segments_are_there = judge_segments(in, verdict);
  if (!judge_inner_vertices(in, verdict) || !segments_are_there) return;
  const auto pieces = wall_pieces(in, verdict);
  if (!pieces) return;
  if (is_full_hull(in.complex)) {
    judge_hull_coverage(in, *pieces, verdict);
  } else {
    judge_coverage(in, *pieces, verdict);
  }
  judge_stray_faces(in, *pieces, verdict);
  if (in.mesh.neighbors) judge_neighbors(in.mesh, facet_uses(in.mesh.simplices), verdict);
  if (is_triangulation_so_far(verdict)) then(in, *pieces);
}

}  // namespace

bool judge_simplices_in_space(const ExactMesh& mesh, std::size_t ambient_dimension, bool oriented,
                              Verdict& verdict) {
  const bool faces_are_sound = judge_listed_faces(mesh, ambient_dimension, verdict);
  if (mesh.points.dimension() == static_cast<int>(ambient_dimension)) {
    return judge_simplices(mesh, oriented, verdict) && faces_are_sound;
  }
  // All points lie in one hyperplane: whatever is not a triangle or edge is flat.
  for (const Simplex& simplex : mesh.simplices) {
    verdict.add(Rule::kWrongDimension, {.simplices = {simplex}});
  }
  return mesh.simplices.empty() && faces_are_sound;
}

bool is_triangulation_so_far(const Verdict& verdict) {
  return std::all_of(verdict.tallies().begin(), verdict.tallies().end(), [](const auto& tally) {
    return tally.first == Rule::kSteinerForbidden || tally.first == Rule::kOrientation ||
           tally.first == Rule::kWrongNeighbor;
  });
}

void judge_against_empty_domain(const ExactMesh& mesh, Verdict& verdict) {
  for (const Simplex& simplex : mesh.simplices) {
    verdict.add(Rule::kOutside, {.simplices = {simplex}});
  }
  for (const Simplex& face : mesh.faces) verdict.add(Rule::kOutside, {.simplices = {face}});
  judge_vertex_set(mesh, verdict);
}

void judge_plc_triangulation_by_lemma(const ExactMesh& mesh, const Domain& domain,
                                      const Options& options, const fast::SimplexFacts* known,
                                      bool steiner_points_allowed, const OfTriangulation& then,
                                      Verdict& verdict) {
  const PiecewiseLinearComplex& complex = domain.complex;
  const std::size_t dimension = complex.ambient_dimension();
  if (complex.points.empty()) return judge_against_empty_domain(mesh, verdict);
  const bool sound = known != nullptr
                         ? judge_listed_faces(mesh, dimension, verdict)
                         : judge_simplices_in_space(mesh, dimension, options.oriented, verdict);
  if (!sound) return;
  VertexPlaces places = match_vertices(mesh, complex);
  VertexSearch search(mesh, places.used);
  const bool complete =
      judge_vertices(mesh, complex, places, steiner_points_allowed, search, verdict);
  std::vector<FacetUse> uses;
  if (known == nullptr) {
    uses = facet_uses(mesh.simplices);
    if (!judge_facet_matching(mesh, uses, verdict)) return;
  }
  if (!complete) return;
  locate_steiner_points(mesh, complex, places);
  verdict.steiner_points = count_steiner_points(places);
  if (known != nullptr) uses = uses_of_interest(mesh, complex, places, *known);
  const SegmentChains chains(mesh, complex, places);
  const Regions regions = domain.regions();
  judge_cells({mesh, complex, regions, uses, known, places, chains, search}, then, verdict);
}

}  // namespace circumspect::check
