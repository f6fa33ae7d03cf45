// Is a triangulation of a domain constrained Delaunay? Book: Definitions 4.6 and 4.7, Lemma 4.10.
#pragma once

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Requires: a triangulation of the domain, or of the domain with every vertex of the mesh added.

// Lemma 4.10 (iii), and the same lemma in the plane of each polygon with dangling triangles: every
// facet off the walls is locally Delaunay, every edge between two dangling triangles off the
// segments is so in their plane. cdt.facet-not-local, cdt.dangling-not-delaunay.
void judge_constrained_delaunay_by_lemma(const MeshedDomain& in,
                                         const std::vector<WallPiece>& pieces, Verdict& verdict);

}  // namespace circumspect::check
