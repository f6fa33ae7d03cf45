// Judges a mesh of a domain, by lemma: the claims of Section 4.5.
#pragma once

#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Is the mesh, with the triangles and edges listed beside it,
//   plc-triangulation      a triangulation of the domain (Definition 4.4)?
//   steiner-triangulation  one with further vertices (Definition 4.5)?
//   cdt                    a constrained Delaunay triangulation (Definition 4.7, Lemma 4.10)?
//   steiner-cdt            one of the domain with further vertices?
//   conforming-delaunay    a Steiner triangulation in which every simplex is Delaunay (Definition
//                          4.5)?
// The lemmas are linear but for sorting and for searches in space; docs/theory/domains.md
// proves that they suffice.
// `known`: what is known of the mesh's simplices, if anything; the verdict is the same with and
// without. oracle/judge/judge.hpp finds it out.
// Requires: a claim about a domain, by lemma; a valid domain (see validity.hpp) in the plane or in
// space; a mesh without weights that has no points, or points of the domain's dimension.
Verdict judge_domain(Claim claim, const ExactMesh& mesh, const Domain& domain,
                     const Options& options = {}, const fast::SimplexFacts* known = nullptr);

// Does the claim say anything of balls? May the mesh have vertices that the domain has not?
bool is_about_balls(Claim claim);
bool allows_steiner_points(Claim claim);

}  // namespace circumspect::check
