// circumspect replay FORMULA REFUTATION
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"
#include "reference/existence/dimacs.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::cli {
namespace {

struct ReplayOptions {
  std::string formula;
  std::string refutation;
  OutputOptions output;
};

std::optional<std::string> contents(const std::string& path, Output& output) {
  auto source = formats::load(path);
  if (source) return std::move(source->text);
  output.error(ExitCode::kInputFault, "file", path, source.error().to_string());
  return std::nullopt;
}

void report_malformed(const std::string& path, const existence::MalformedProof& fault,
                      Output& output) {
  output.error(
      ExitCode::kInputFault, "file", path,
      fmt::format("{}:{}: expected {}, found {}", path, fault.line, fault.expected, fault.found));
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
      fmt::format("refuted: {} {} {} by {}", on_one_line(options.formula),
                  report::counted(static_cast<std::size_t>(formula->variables), "variable"),
                  report::counted(formula->clauses.size(), "clause"),
                  report::counted(refutation->size(), "step"));
  if (!replayed) {
    output.exit_with(ExitCode::kFails);
    const std::size_t step = replayed.error().step;
    verdict =
        fmt::format("fails: {} {}", on_one_line(options.refutation),
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
      "  circumspect replay room-cdt.cnf room-cdt.drat\n"
      "\n"
      "Each step must follow from the clauses before it by unit propagation. Then nothing "
      "satisfies the\n"
      "formula. replay does not check that the formula encodes the domain. Comments in the "
      "formula\n"
      "explain its clauses, and `circumspect inspect DOMAIN --refutations PREFIX` derives it "
      "from the\n"
      "domain again, so that you can compare the two.\n"
      "\n"
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
