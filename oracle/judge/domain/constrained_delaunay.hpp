// Is a triangulation of a domain constrained Delaunay, or conforming Delaunay? Book: Definitions
// 4.5 to 4.7, Lemma 4.10.
#pragma once

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// ---- Constrained Delaunay ----
// Is a triangulation of a domain constrained Delaunay? Book: Definitions 4.6 and 4.7, Lemma 4.10.

// Requires: a triangulation of the domain, or of the domain with every vertex of the mesh added.

// Lemma 4.10 (iii), and the same lemma in the plane of each polygon with dangling triangles: every
// facet off the walls is locally Delaunay, every edge between two dangling triangles off the
// segments is so in their plane. cdt.facet-not-local, cdt.dangling-not-delaunay.
void judge_constrained_delaunay_by_lemma(const MeshedDomain& in,
                                         const std::vector<WallPiece>& pieces, Verdict& verdict);

// ---- Conforming Delaunay ----
// Is every simplex of a triangulation of a domain Delaunay? Book: Definition 4.5 ("a conforming
// Delaunay triangulation").

// Every facet of two simplices is locally Delaunay (delaunay.facet-not-local); the ball of a simplex
// with a facet on the boundary holds no vertex (delaunay.vertex-in-ball); and every dangling simplex
// has an empty circumball (delaunay.no-empty-ball). Near-linear where balls at the boundary are
// small. Requires: a Steiner triangulation.
void judge_delaunay_by_lemma(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                             Verdict& verdict);

}  // namespace circumspect::check
