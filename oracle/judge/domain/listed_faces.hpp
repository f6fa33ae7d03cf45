// The triangles and edges that a program lists beside its simplices.
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// triangulation.unknown-vertex, simplex.wrong-dimension (triangles and edges in space, edges in the
// plane), simplex.repeated-vertex, simplex.degenerate. True if all can be worked with.
bool judge_listed_faces(const ExactMesh& mesh, std::size_t ambient_dimension, Verdict& verdict);

// Every listed face must be a face of a simplex, a piece of a wall, an edge of such a piece or a
// link of a segment; others are domain.outside where there is no domain, else complex.overlap:
// where there is, space is filled with simplices whose face they are not. Such a simplex is named,
// if there is one, with a point of both. Counts those that rightly are faces of no simplex:
// Verdict::dangling.
// `pieces` ascending.
void judge_stray_faces(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                       Verdict& verdict);

// Of some edges in space, ascending, those that no simplex and no piece has.
std::vector<Simplex> edges_of_nothing(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                                      const std::vector<Simplex>& edges);

// Is it a facet of a simplex? Requires: ascending; in a wall or listed, if `uses` are not all.
bool is_facet(const std::vector<FacetUse>& uses, const Simplex& facet);
// Is it one of the pieces? Requires: ascending, both.
bool is_piece(const std::vector<WallPiece>& pieces, const Simplex& facet);

}  // namespace circumspect::check
