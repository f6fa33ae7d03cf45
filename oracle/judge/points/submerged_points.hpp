// The points of a weighted set that are no vertices: are they submerged? Book: Section 2.8 by way of
// Section 5.2 (weighted Delaunay triangulations).
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/judge/points/ambiguity.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::check {

// Each point that is no vertex must lie in some simplex (else triangulation.unused-point: a point
// outside is a vertex whatever its weight), its lifted companion on or above the witness plane of
// that simplex (else weighted.point-below-plane). Returns how many orientations it took to find the
// simplices (reference/kernel/exact/point_search.hpp). Requires: the mesh is a triangulation of its vertices,
// and `uses` are those of its facets.
std::uint64_t judge_submerged_points(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                     Verdict& verdict, Ambiguity& ambiguity);

}  // namespace circumspect::check
