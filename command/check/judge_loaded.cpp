#include "command/check/judge_loaded.hpp"

namespace circumspect::cli {

tl::expected<Verdict, std::string> judge_loaded(Claim claim, LoadedMesh& loaded,
                                                Duplicates duplicates,
                                                const check::Options& options,
                                                const Domain* domain) {
  if (duplicates == Duplicates::kMerge) {
    return check::judge_merged(claim, loaded.mesh, domain, options);
  }
  auto verdict = check::judge(claim, loaded.mesh, domain, options);
  if (verdict) return std::move(*verdict);
  return tl::unexpected(equal_points_fault(loaded, verdict.error().repeated));
}

}  // namespace circumspect::cli
