// Is a mesh a triangulation of a domain? Book: Definitions 4.4 and 4.5.
#pragma once

#include <functional>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

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

}  // namespace circumspect::check
