// Judges a mesh in exact numbers, of points or of a domain, by lemma or by definition.
#pragma once

#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Does the claim hold? Here alone it is decided whether the lemmas or the definitions answer; the
// answer is the same. `known`: what is known of the mesh's simplices, which only the lemmas use.
// Requires: `domain` if and only if the claim is about one, and what judge_points or judge_domain
// require.
Verdict judge_exactly(Claim claim, const ExactMesh& mesh, const Domain* domain = nullptr,
                      const Options& options = {}, const fast::SimplexFacts* known = nullptr);

}  // namespace circumspect::check
