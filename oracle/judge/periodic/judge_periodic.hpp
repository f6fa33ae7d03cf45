// Judges whether a mesh that a lattice repeats is Delaunay: docs/theory/questions.md.
#pragma once

#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// By definition and by lemma, which do not name the same rules where the claim does not hold.
// Requires: the mesh was unfolded (unfolded.hpp).
Verdict judge_periodic(const Mesh& mesh, const Options& options);

}  // namespace circumspect::check
