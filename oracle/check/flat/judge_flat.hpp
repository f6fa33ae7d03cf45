// Large meshes of doubles, judged where they lie (oracle/fast), in the words of all other verdicts.
#pragma once

#include <optional>

#include "oracle/check/check.hpp"
#include "oracle/formats/flat_mesh.hpp"

namespace circumspect::check {

// The verdict that the claim holds, which is then what judge() says of the same mesh, and none of its
// points equal; none if it does not hold, or cannot be decided so: then judge() says what is wrong. Of a
// claim with weights, these are the first attributes. `threads`: 0: as many as the machine has; the answer
// is the same for any number.
std::optional<Verdict> judge_flat(Claim claim, const formats::FlatMesh& mesh,
                                  const Options& options = {}, unsigned threads = 0);

}  // namespace circumspect::check
