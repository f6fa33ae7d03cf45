// What keeps the processes of others within limits, or parts of a mesh in files without names, is
// written for Linux: elsewhere it says so.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/check/judge_in_parts.hpp"
#include "command/subcommands.hpp"

namespace circumspect::cli {
namespace {

std::string refusal(const std::string& what) {
  return fmt::format("expected Linux for {}, found another system", what);
}

void refuse(CLI::App& app, const std::string& name, const std::string& what, ExitCode& exit_code) {
  CLI::App* const command = app.add_subcommand(name, what + " (on Linux only)");
  command->prefix_command();  // whatever follows
  command->callback([name, &exit_code] { exit_code = usage_error(refusal(name)); });
}

}  // namespace

void add_campaign(CLI::App& app, ExitCode& exit_code) {
  refuse(app, "campaign",
         "Run a program on generated inputs, judge its meshes, and make failing inputs small",
         exit_code);
}

void add_minimize(CLI::App& app, ExitCode& exit_code) {
  refuse(app, "minimize", "Reduce an input on which a program fails to a small one", exit_code);
}

void add_memory_option(CLI::App& command, std::optional<std::uint64_t>& bytes) {
  command
      .add_option_function<std::string>(
          "--memory", [&bytes](const std::string&) { bytes = 0; },
          "Judge the mesh part by part (on Linux only)")
      ->option_text("SIZE");
}

tl::expected<JudgedInParts, NotJudged> judge_in_parts(Claim, const std::string&,
                                                      const std::optional<std::string>&,
                                                      std::uint64_t, const check::Options&) {
  return tl::unexpected(NotJudged{ExitCode::kUsage, refusal("--memory")});
}

}  // namespace circumspect::cli
