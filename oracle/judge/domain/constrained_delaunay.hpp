// Is a triangulation of a domain constrained Delaunay, or conforming Delaunay? Book: Definitions
// 4.5 to 4.7, Lemma 4.10.
#pragma once

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// ---- Constrained Delaunay ----
// Is a triangulation of a domain constrained Delaunay? Book: Definitions 4.6 and 4.7, Lemma 4.10.

// Both require a triangulation of the domain, or of the domain with every vertex of the mesh added.

// Lemma 4.10 (iii), and the same lemma in the plane of each polygon with dangling triangles: every
// facet off the walls is locally Delaunay, every edge between two dangling triangles off the
// segments is so in their plane. cdt.facet-not-local, cdt.dangling-not-delaunay.
void judge_constrained_delaunay_by_lemma(const MeshedDomain& in,
                                         const std::vector<WallPiece>& pieces, Verdict& verdict);

// Definition 4.7: no simplex has a vertex that is visible from it in its open circumball; of a
// dangling triangle only what is in its plane is visible, and all its circumballs cut that in its
// circumdisk. cdt.visible-vertex-in-ball, cdt.dangling-not-delaunay.
// `complex` has the vertices of the mesh.
void judge_constrained_delaunay_by_definition(const ExactMesh& mesh,
                                              const PiecewiseLinearComplex& complex,
                                              Verdict& verdict);

// ---- Conforming Delaunay ----
// Is every simplex of a triangulation of a domain Delaunay? Book: Definition 4.5 ("a conforming
// Delaunay triangulation").

// Every facet of two simplices is locally Delaunay (delaunay.facet-not-local); the ball of a simplex
// with a facet on the boundary holds no vertex (delaunay.vertex-in-ball); and every dangling simplex
// has an empty circumball (delaunay.no-empty-ball). Near-linear where balls at the boundary are
// small. Requires: a Steiner triangulation.
void judge_delaunay_by_lemma(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                             Verdict& verdict);

// Every simplex, listed ones included, against every vertex.
void judge_delaunay_by_definition(const ExactMesh& mesh, Verdict& verdict);

}  // namespace circumspect::check
