// Do the simplices cover the inside of a domain once, and nothing else?
#pragma once

#include <vector>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// All require matched facets, and pieces that tile the walls, in order of their vertices.

// Of an enclosed domain: a simplex on each side of each piece that is inside, none on the others;
// and every facet of one simplex is a piece. domain.uncovered; domain.outside for each simplex that
// is; complex.overlap where a vertex hangs in a facet.
void judge_coverage(const MeshedDomain& in, const std::vector<WallPiece>& pieces, Verdict& verdict);

// Of a convex hull of full dimension: the simplices are a triangulation of it (triangulation.…), no
// Steiner point makes it larger (domain.outside for each simplex that has one that does), and every
// piece is a facet of them (domain.uncovered).
void judge_hull_coverage(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                         Verdict& verdict);

}  // namespace circumspect::check
