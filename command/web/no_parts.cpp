// A browser has no files that the memory could be put away in: check --memory is not there.
#include "command/check/judge_in_parts.hpp"

namespace circumspect::cli {

void add_memory_option(CLI::App&, std::optional<std::uint64_t>&) {}

tl::expected<JudgedInParts, NotJudged> judge_in_parts(Claim, const std::string&,
                                                      const std::optional<std::string>&,
                                                      std::uint64_t, const check::Options&) {
  return tl::unexpected(NotJudged{ExitCode::kUsage, "expected no --memory in a browser"});
}

}  // namespace circumspect::cli
