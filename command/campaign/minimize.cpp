// circumspect minimize INPUT -o OUT -- CMD…
#include <filesystem>
#include <memory>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/campaign/campaign_inputs.hpp"
#include "command/campaign/campaign_options.hpp"
#include "command/campaign/campaign_page.hpp"
#include "command/campaign/stop_flag.hpp"
#include "command/campaign/subject.hpp"
#include "command/output/output.hpp"
#include "command/output/picture_output.hpp"
#include "command/subcommands.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/runner.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct MinimizeOptions {
  std::string input;
  std::string output_file;
  std::string html;  // what is left of it, to look at; empty: none
  SubjectOptions subject;
  OutputOptions output;
};

std::string output_extension(const MinimizeOptions& options, const campaign::Subject& subject) {
  const std::string extension = formats::extension(options.output_file);
  if (!extension.empty()) return extension;
  return subject.is_about_domains() ? ".poly" : ".node";
}

bool can_write(const std::string& extension, const campaign::Subject& subject) {
  return subject.is_about_domains() ? campaign::is_domain_extension(extension)
                                    : campaign::is_points_extension(extension);
}

std::string write_input(const MinimizeOptions& options, const campaign::Subject& subject,
                        const campaign::Input& input) {
  const auto text = campaign::file_text(input, output_extension(options, subject),
                                        subject.first_index, subject.dimension);
  if (!text)
    return options.output_file + ": expected a format that can express this domain, found another";
  return write_file(options.output_file, [&](std::ostream& stream) { stream << *text; });
}

void report(const MinimizeOptions& options, const campaign::Subject& subject,
            const campaign::Outcome& outcome, std::size_t before, std::size_t after,
            Output& output) {
  const std::string program = std::filesystem::path(subject.command.front()).filename();
  output.text(outcome.explanation);
  output.text(outcome.text + "\n");
  output.text(fmt::format("minimized: {} {} {} to {} {}\n", on_one_line(program), outcome.signature,
                          report::counted(before, "point"), after,
                          on_one_line(options.output_file)));
  if (!output.wants_json()) return;
  report::Json result = {{"minimized", options.output_file},
                         {"signature", outcome.signature},
                         {"text", outcome.text},
                         {"command", subject.command},
                         {"points", before},
                         {"minimal_points", after}};
  if (outcome.kind == campaign::OutcomeKind::kFails) result["verdict"] = outcome.verdict;
  output.json(std::move(result));
}

// Makes the input small and writes it. The program has failed on it with this outcome.
void minimize(const MinimizeOptions& options, const campaign::Subject& subject,
              const campaign::Input& input, const std::string& signature, campaign::Runner& runner,
              Output& output) {
  if (!options.output.quiet) {
    say(fmt::format("minimize: {} points; ends after {:g} s at the latest (--minimize-time)\n",
                    campaign::point_count(input), options.subject.minimise().time.count()));
  }
  const std::atomic<bool>& interrupted = stop_flag();  // what an interrupt does is settled by now
  output.watch("minimize");
  output.begin("making " + options.input + " small");
  const campaign::Input minimal =
      campaign::minimised(input, signature, runner, options.subject.minimise(), interrupted);
  const campaign::Outcome outcome = runner.run(minimal);
  output.end_watch();
  const std::string failure = write_input(options, subject, minimal);
  if (!failure.empty()) {
    output.error(ExitCode::kUsage, "input", options.input, failure);
    return;
  }
  report(options, subject, outcome, campaign::point_count(input), campaign::point_count(minimal),
         output);
  if (!options.html.empty()) {
    const report::Json finding = {
        {"signature", outcome.signature},
        {"count", 1},
        {"text", outcome.text},
        {"reproduce", on_one_line(fmt::format("{}", fmt::join(subject.command, " ")))}};
    write_page(options.html, minimal_page(finding, minimal, subject, runner), output);
  }
  if (interrupted) output.exit_with(ExitCode::kUndecided);
}

// Errors: there is no place for its files.
tl::expected<std::unique_ptr<campaign::Runner>, std::string> new_runner(
    const campaign::Subject& subject) {
  try {
    return std::make_unique<campaign::Runner>(subject);
  } catch (const std::system_error& error) {
    return tl::unexpected(std::string(error.what()));
  }
}

// Then it fails on all inputs, as a program does that cannot start. Domains without points are not
// given to programs.
bool fails_without_points(const campaign::Input& input, const campaign::Outcome& outcome,
                          campaign::Runner& runner) {
  if (!std::holds_alternative<campaign::PointsCase>(input)) return false;
  const campaign::Outcome without = runner.run_anew(campaign::PointsCase{});
  return without.kind == outcome.kind && (without.signature == outcome.signature ||
                                          without.signature == outcome.signature + "-flat");
}

ExitCode run(const MinimizeOptions& options) {
  Output output(options.output);
  const auto fault = [&](ExitCode code, const std::string& message) {
    output.error(code, "input", options.input, message);
    return output.finish();
  };
  bool not_found = false;
  const auto subject = subject_of(options.subject, not_found);
  if (!subject) return fault(not_found ? ExitCode::kInputFault : ExitCode::kUsage, subject.error());
  if (!can_write(output_extension(options, *subject), *subject)) {
    return fault(ExitCode::kUsage,
                 options.output_file + ": expected the extension of a file of inputs");
  }
  std::vector<std::string> read = files_of_domain(options.input);
  read.insert(read.end(), subject->command.begin(), subject->command.end());
  const std::string overwriting =
      page_fault(options.html, {{"the small input", options.output_file}}, read);
  if (!overwriting.empty()) return fault(ExitCode::kUsage, overwriting);
  if (!options.output.quiet) say(note_on_names(options.subject));
  const auto input = campaign_input(*subject, options.input);
  if (!input) return fault(ExitCode::kInputFault, input.error());
  const auto runner = new_runner(*subject);
  if (!runner) return fault(ExitCode::kInputFault, runner.error());
  const campaign::Outcome outcome = (*runner)->run(*input);
  if (!campaign::is_finding(outcome.kind)) {
    return fault(ExitCode::kInputFault,
                 fmt::format("{}: expected an input on which the program fails, found: {}{}{}",
                             options.input, campaign::word(outcome.kind),
                             outcome.text.empty() ? "" : ": ", outcome.text));
  }
  if (fails_without_points(*input, outcome, **runner)) {
    output.note(
        "the program fails in the same way where there are no points: is the command right?");
  }
  minimize(options, *subject, *input, outcome.signature, **runner, output);
  return output.finish();
}

}  // namespace

void add_minimize(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<MinimizeOptions>();
  CLI::App* command =
      app.add_subcommand("minimize", "Reduce an input on which a program fails to a small one");
  command->footer(
      "Examples:\n"
      "  circumspect minimize big.node -o small.node -- ./my_program {points} {mesh}\n"
      "  circumspect minimize part.poly -o small.poly --mesh x.1.ele -- tetgen -pQ {domain}\n"
      "\n"
      "minimize leaves out points and cells, and turns coordinates into small integers, as "
      "long as the\n"
      "mesh breaks the same rule or the program ends in the same way.\n"
      "\n"
      "Exit codes: 0 written, 2 usage, 3 the input is at fault or the program does not fail "
      "on\n"
      "it, 4 interrupted (the smallest input so far is written), 5 internal error.");
  command->add_option("input", options->input, "Points or a domain, in any format")->required();
  command
      ->add_option("-o,--output", options->output_file, "The file for the small input; - is stdout")
      ->required()
      ->option_text("OUT");
  add_page_option(*command, options->html, "the small input, and the witness in its mesh");
  add_subject_options(*command, options->subject);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
