// Judges a mesh that was read from files.
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "command/input/input.hpp"
#include "oracle/judge/judge.hpp"

namespace circumspect::cli {

// What check::judge says of the mesh, in which equal points are merged on the way if they have not
// been, or one line that says what is wrong with them if they are refused.
inline tl::expected<Verdict, std::string> judge_loaded(Claim claim, LoadedMesh& loaded,
                                                       Duplicates duplicates,
                                                       const check::Options& options,
                                                       const Domain* domain = nullptr) {
  if (duplicates == Duplicates::kMerge) {
    return check::judge(claim, check::Merging{loaded.mesh, &loaded.merged}, domain, options);
  }
  auto verdict = check::judge(claim, loaded.mesh, domain, options);
  if (verdict) return std::move(*verdict);
  return tl::unexpected(equal_points_fault(loaded, verdict.error().repeated));
}

}  // namespace circumspect::cli
