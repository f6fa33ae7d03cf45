// Judges a mesh in files part by part: check --memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include "command/output/output.hpp"
#include "oracle/judge/judge.hpp"

namespace circumspect::cli {

// --memory SIZE: about so many bytes the command may take; nothing if it is not given.
void add_memory_option(CLI::App& command, std::optional<std::uint64_t>& bytes);

// What is said of a mesh that is never in memory as a whole, as oracle/distributed has it.
struct JudgedInParts {
  Verdict verdict;
  Mesh named;  // has what the witnesses name, under the names that it has in the whole
};

// Why there is no verdict.
struct NotJudged {
  ExitCode code = ExitCode::kInputFault;
  std::string message;
};

// What judge_loaded says of a mesh in an .npy or an .ele file that is read as doubles, with equal
// points refused. What does not fit the memory lies in files without names in TMPDIR, or /var/tmp.
// Not judged: what distributed::read_slices refuses; more parts than kMostParts; no room on the
// disk.
inline constexpr std::size_t kMostParts = 1024;
tl::expected<JudgedInParts, NotJudged> judge_in_parts(Claim claim, const std::string& mesh,
                                                      const std::optional<std::string>& points,
                                                      std::uint64_t memory,
                                                      const check::Options& options);

}  // namespace circumspect::cli
