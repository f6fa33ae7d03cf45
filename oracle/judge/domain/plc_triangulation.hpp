// Is a mesh a triangulation of a domain, and as stages of that: are segments and lone vertices in
// the mesh, and which facets tile the polygons? Book: Definitions 4.4 and 4.5.
#pragma once

#include <functional>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/judge/points/check.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// ---- PLC triangulation ----

// What remains to be asked of a mesh that is a triangulation, Steiner points aside.
using OfTriangulation =
    std::function<void(const MeshedDomain& in, const std::vector<WallPiece>& pieces)>;

// Conditions 0–7 of docs/theory/domains.md, near-linear; without those that are known to hold, if
// `known` is anything.
void judge_plc_triangulation_by_lemma(const ExactMesh& mesh, const Domain& domain,
                                      const Options& options, const fast::SimplexFacts* known,
                                      bool steiner_points_allowed, const OfTriangulation& then,
                                      Verdict& verdict);

// Each simplex and listed face by itself. True if they can be worked with.
bool judge_simplices_in_space(const ExactMesh& mesh, std::size_t ambient_dimension, bool oriented,
                              Verdict& verdict);

// Has nothing been found but Steiner points, and orders of vertices or neighbours?
bool is_triangulation_so_far(const Verdict& verdict);

// The witnesses that nothing of the mesh belongs to an empty domain.
void judge_against_empty_domain(const ExactMesh& mesh, Verdict& verdict);

// ---- Segments ----

// domain.vertex-in-edge: an edge of the mesh whose ends are on one segment, but not next to each
// other. domain.segment-missing: a link that is no edge of the mesh, or one inside a polyhedron that
// is no edge of a simplex there. True if nothing is wrong.
bool judge_segments(const MeshedDomain& in, Verdict& verdict);

// domain.vertex-missing: a vertex of the domain inside a polyhedron that no simplex has for a vertex.
bool judge_inner_vertices(const MeshedDomain& in, Verdict& verdict);

// ---- Polygon tiling ----

// The pieces of all walls, in order of their vertices; nothing if a polygon is not tiled exactly,
// edge to edge, by facets of simplices and listed triangles: domain.polygon-not-tiled, complex.overlap
// where two of them are on one side of an edge, domain.vertex-missing where the triangles pass over a
// vertex of the polygon. One violation a polygon. In the plane the pieces are the links of the
// segments. Requires: judge_segments found nothing.
std::optional<std::vector<WallPiece>> wall_pieces(const MeshedDomain& in, Verdict& verdict);

}  // namespace circumspect::check
