// Judges a mesh that was read from files.
#pragma once

#include <optional>
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

// How long that takes by definition, about, on a machine of 2023: every pair of simplices is looked at, and every
// simplex with every point. By lemma nobody need wait long.
std::optional<double> seconds_of_judging(const Mesh& mesh, const check::Options& options);

}  // namespace circumspect::cli
