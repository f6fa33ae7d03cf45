// From a mesh that was read to the verdict on it.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "command/input/input.hpp"
#include "oracle/judge/judge.hpp"

namespace circumspect::cli {

// What check::judge says of the mesh, in which equal points are merged on the way, or one line that says
// what is wrong with them if they are refused.
tl::expected<Verdict, std::string> judge_loaded(Claim claim, LoadedMesh& loaded,
                                                Duplicates duplicates,
                                                const check::Options& options,
                                                const Domain* domain = nullptr);

}  // namespace circumspect::cli
