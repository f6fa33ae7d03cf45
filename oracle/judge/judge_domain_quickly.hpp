// Meshes of domains, of whose simplices oracle/judge/fast says what it can.
#pragma once

#include <optional>

#include "oracle/judge/domain/judge_domain.hpp"

namespace circumspect::check {

// What there is to know of the simplices for this claim; nothing if the fast judge leaves the mesh
// undecided, if a coordinate is no double, or if `options` ask for more. `threads`: 0: as many as the
// machine has; the answer is the same for any number. Requires: as judge_domain.
std::optional<KnownVolume> known_volume(Claim claim, const Mesh& mesh, const Domain& domain,
                                        const Options& options, unsigned threads = 0);

// The verdict of judge_domain, sooner.
Verdict judge_domain_quickly(Claim claim, const Mesh& mesh, const Domain& domain,
                             const Options& options = {}, unsigned threads = 0);

}  // namespace circumspect::check
