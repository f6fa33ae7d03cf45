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

std::optional<double> seconds_of_judging(const Mesh& mesh, const check::Options& options) {
  if (options.by != check::By::kDefinition) return std::nullopt;
  const auto simplices = static_cast<double>(mesh.simplices.size());
  const auto points = static_cast<double>(mesh.points());
  return simplices * simplices / 2 * 2e-5 + simplices * points * 2e-6;
}

}  // namespace circumspect::cli
