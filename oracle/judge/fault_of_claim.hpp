// Whether a claim makes sense of a mesh at all.
#pragma once

#include <string>

#include "oracle/model/claim.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"

namespace circumspect::check {

// Why the claim, with what `options` demand beside it, makes no sense of the mesh, one line that
// says what to do; empty if it does.
std::string fault_of_claim(Claim claim, const Mesh& mesh, const Options& options);

}  // namespace circumspect::check
