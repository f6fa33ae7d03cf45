// Which facets tile the polygons of a domain?
#pragma once

#include <optional>
#include <vector>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// The pieces of all walls, in order of their vertices; nothing if a polygon is not tiled exactly,
// edge to edge, by facets of simplices and listed triangles: domain.polygon-not-tiled,
// complex.overlap where two of them are on one side of an edge, domain.vertex-missing where the
// triangles pass over a vertex of the polygon. One violation a polygon. In the plane the pieces are
// the links of the segments. Requires: judge_segments found nothing.
std::optional<std::vector<WallPiece>> wall_pieces(const MeshedDomain& in, Verdict& verdict);

}  // namespace circumspect::check
