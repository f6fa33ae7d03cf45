// Is every simplex of a triangulation of a domain Delaunay? Book: Definition 4.5 ("a conforming
// Delaunay triangulation").
#pragma once

#include <cstddef>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/judge/domain/vertex_index.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Every facet of two simplices is locally Delaunay (delaunay.facet-not-local); the ball of a
// simplex with a facet on the boundary holds no vertex (delaunay.vertex-in-ball); and every
// dangling simplex has an empty circumball (delaunay.no-empty-ball). Near-linear where balls at the
// boundary are small. Requires: a Steiner triangulation.
void judge_delaunay_by_lemma(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                             Verdict& verdict);

// Adds the vertices in the open circumball of a simplex that has this facet on the boundary.
// `index` holds the points of the mesh.
void judge_ball_at_boundary(const ExactMesh& mesh, const VertexIndex& index, std::size_t simplex,
                            const Simplex& facet, Verdict& verdict);

}  // namespace circumspect::check
