// circumspect campaign -- CMD…
#include "fuzz/campaign/campaign.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "command/campaign/campaign_page.hpp"
#include "command/campaign/campaign_plan.hpp"
#include "command/campaign/campaign_report.hpp"
#include "command/campaign/stop_flag.hpp"
#include "command/campaign/subject.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

// What is happening, on standard error: how the time is shared out, when the making small goes on
// alone, and on a terminal one line that is written over and over.
class Narrator {
 public:
  Narrator(const campaign::Plan& plan, const OutputOptions& output)
      : plan_(plan), speaks_(!output.quiet), is_terminal_(speaks_ && isatty(STDERR_FILENO) == 1) {
    if (!speaks_ || !plan.seconds) return;
    say(fmt::format(
        "campaign: {:g} s; once something is found, the last {:g} s of them are for making it "
        "small\n",
        *plan.seconds, campaign::kMinimisingShare * *plan.seconds));
  }
  ~Narrator() {
    if (is_terminal_) say(fmt::format("\r{:60}\r", ""));
  }
  Narrator(const Narrator&) = delete;
  Narrator& operator=(const Narrator&) = delete;

  void show(const campaign::Progress& progress) {
    if (speaks_ && !progress.drawing && progress.minimising > 0 && !said_) {
      said_ = true;
      say(fmt::format("{}campaign: {:.1f} s, no more cases; findings that are made small: {}, {}\n",
                      is_terminal_ ? "\r" : "", progress.seconds, progress.minimising, until()));
    }
    if (!is_terminal_) return;
    say(fmt::format(
        "\r{}, {}, {} to make small, {:.0f} s ", report::counted(progress.cases, "case"),
        report::counted(progress.signatures, "signature"), progress.minimising, progress.seconds));
  }

 private:
  std::string until() const {
    if (plan_.seconds) return fmt::format("until {:g} s have passed", *plan_.seconds);
    return fmt::format("each for at most {:g} s (--minimize-time)", plan_.minimise.time.count());
  }

  const campaign::Plan& plan_;
  bool speaks_;
  bool is_terminal_;
  bool said_ = false;
};

ExitCode exit_code_of(const campaign::Result& result) {
  if (!result.findings.empty()) return ExitCode::kFails;
  const bool holds = !result.interrupted && judged_cases(result) > 0;
  return holds ? ExitCode::kHolds : ExitCode::kUndecided;
}

void report(const campaign::Result& result, const campaign::Plan& plan,
            const CampaignOptions& options, Output& output) {
  const std::string program = std::filesystem::path(plan.subject.command.front()).filename();
  output.exit_with(exit_code_of(result));
  const auto write_report = [&output](const std::string& path, const std::string& text) {
    if (path.empty()) return;
    const std::string failure = write_file(path, [&](std::ostream& stream) { stream << text; });
    if (!failure.empty()) output.error(ExitCode::kUsage, "report", path, failure);
  };
  write_report(options.junit, campaign_junit(result, program));
  write_report(options.sarif, report::document_text(campaign_sarif(result)));
  if (!options.html.empty()) {
    const picture::Page page = campaign_page(result, plan, program);
    const std::string failure =
        write_file(options.html, [&](std::ostream& stream) { page.write(stream); });
    if (!failure.empty()) output.error(ExitCode::kUsage, "html", options.html, failure);
  }
  output.text(campaign_text(result));
  if (options.annotates) output.text(campaign_annotations(result, program));
  output.text(campaign_verdict(result, program, plan.magnitudes) + "\n");
  if (output.wants_json()) output.json(campaign_json(result, plan, program));
}

ExitCode run(const CampaignOptions& options) {
  const auto plan = plan_of(options);
  if (!plan) return plan.error();
  Output output(options.output);
  if (!options.output.quiet) say(note_on_names(options.subject));
  const auto result = [&] {
    Narrator narrator(*plan, options.output);
    return campaign::run(*plan, stop_flag(), [&narrator](const campaign::Progress& progress) {
      narrator.show(progress);
    });
  }();
  if (!result) {
    output.error(ExitCode::kInputFault, "campaign", plan->output, result.error());
  } else {
    report(*result, *plan, options, output);
  }
  return output.finish();
}

constexpr const char* kFooter =
    "Examples:\n"
    "  circumspect campaign --time 60s -- ./my_program {points} {mesh}\n"
    "  circumspect campaign --mesh x.1.ele -- tetgen -JQ {points}\n"
    "  circumspect campaign --points x.qhull --stdin --mesh x.qhull-i --stdout -- "
    "qdelaunay Qt i\n"
    "  circumspect campaign --mesh x.1.ele --claim steiner-cdt -- tetgen -pQ {domain}\n"
    "  circumspect campaign --worker --dimension 2 -- node adapter.mjs\n"
    "  circumspect campaign --domain x.geo --mesh x.mesh --claim steiner-triangulation \\\n"
    "      -- gmsh -3 -v 2 {domain} -o {mesh}\n"
    "\n"
    "Each failure gets a folder campaign/findings/NAME/ with a small input and "
    "reproduce.sh.\n"
    "If you give the same command again, it continues where it stopped, even after Ctrl-C "
    "or kill -9.\n"
    "It also minimizes the findings for which it had no time.\n"
    "\n"
    "Exit codes: 0 nothing found, 1 something found, 2 usage, 3 the program cannot be run, "
    "fails\n"
    "on the first ten inputs, or another campaign began in the folder, 4 interrupted or "
    "nothing\n"
    "judged, 5 internal error.";

}  // namespace

void add_campaign(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CampaignOptions>();
  CLI::App* command = app.add_subcommand(
      "campaign",
      "Run a program on generated inputs, judge its meshes, and make failing inputs small");
  command->footer(kFooter);
  add_campaign_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
