// Judges a mesh that was read from files.
#pragma once

#include <string>
#include <utility>

#include <fmt/format.h>
#include <tl/expected.hpp>

#include "command/input/input.hpp"
#include "oracle/judge/fault_of_claim.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/model/claim.hpp"

namespace circumspect::cli {

// Why the claim makes no sense of the mesh, by what it holds or by its format; empty if it does.
inline std::string fault_of_loaded(Claim claim, const LoadedMesh& loaded,
                                   const check::Options& options) {
  if (loaded.is_surface && !is_about_a_list(claim) && !is_about_a_domain(claim)) {
    return fmt::format(
        "{0}: expected a mesh for the claim {1}, found a surface (check --claim complex {0} judges "
        "it by itself; inspect --domain {0}, or check MESH --domain {0}, takes it for a domain)",
        loaded.name, name(claim));
  }
  const std::string fault = check::fault_of_claim(claim, loaded.mesh, options);
  return fault.empty() ? "" : loaded.name + ": " + fault;
}

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
