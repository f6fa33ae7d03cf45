// circumspect replay FORMULA REFUTATION
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "oracle/cli/output.hpp"
#include "oracle/cli/subcommands.hpp"
#include "reference/existence/dimacs.hpp"

namespace circumspect::cli {
namespace {

struct ReplayOptions {
  std::string formula;
  std::string refutation;
  OutputOptions output;
};

std::optional<std::string> contents(const std::string& path, Output& output) {
  std::ostringstream text;
  // A directory can be opened, and reads as if it were empty.
  std::error_code ignored;
  const bool is_directory = std::filesystem::is_directory(path, ignored);
  std::ifstream file(path, std::ios::binary);
  if (file) text << file.rdbuf();
  if (is_directory || !file) {
    output.error(ExitCode::kInputFault, "file", path, path + ": expected a file that can be read");
    return std::nullopt;
  }
  return text.str();
}

void report_malformed(const std::string& path, const existence::MalformedProof& fault,
                      Output& output) {
  output.error(ExitCode::kInputFault, "file", path,
               fmt::format("{}:{}: expected {}", path, fault.line, fault.expected));
}

void replay(const ReplayOptions& options, Output& output) {
  const auto formula_text = contents(options.formula, output);
  const auto refutation_text = contents(options.refutation, output);
  if (!formula_text || !refutation_text) return;
  const auto formula = existence::read_dimacs(*formula_text);
  if (!formula) return report_malformed(options.formula, formula.error(), output);
  const auto refutation = existence::read_refutation(*refutation_text);
  if (!refutation) return report_malformed(options.refutation, refutation.error(), output);

  const auto replayed = existence::replay(*formula, *refutation);
  std::string verdict =
      fmt::format("refuted: {} {} variables {} clauses by {} steps", options.formula,
                  formula->variables, formula->clauses.size(), refutation->size());
  if (!replayed) {
    output.exit_with(ExitCode::kFails);
    const std::size_t step = replayed.error().step;
    verdict =
        fmt::format("fails: {} {}", options.refutation,
                    step == refutation->size() ? std::string("the empty clause does not follow")
                                               : fmt::format("step {} does not follow", step + 1));
  }
  if (output.wants_text()) output.text(verdict + "\n");
  if (output.wants_json()) {
    report::Json object = {{"formula", options.formula},
                           {"refutation", options.refutation},
                           {"holds", replayed.has_value()}};
    if (!replayed) object["step"] = replayed.error().step + 1;
    output.json(object);
  }
}

}  // namespace

void add_replay(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* command =
      app.add_subcommand("replay", "Check a proof that a domain has no triangulation");
  command->footer(
      "Example:\n"
      "  circumspect inspect room.poly --refutations room      # writes room-cdt.cnf, "
      "room-cdt.drat\n"
      "  circumspect replay room-cdt.cnf room-cdt.drat\n\n"
      "Each step must follow from the clauses before it by unit propagation. What the clauses mean "
      "is\n"
      "explained in reference/existence/matching.hpp.\n\n"
      "Exit codes: 0 the formula cannot be satisfied, 1 the steps do not show it, 2 usage,\n"
      "3 a file is at fault, 5 internal error.");
  command->add_option("formula", options->formula, "The formula: DIMACS")->required();
  command->add_option("refutation", options->refutation, "Its refutation: DRAT, as text")
      ->required();
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] {
    Output output(options->output);
    replay(*options, output);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
