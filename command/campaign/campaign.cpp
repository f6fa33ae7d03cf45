// circumspect campaign -- CMD…
#include "fuzz/campaign/campaign.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "command/campaign/campaign_inputs.hpp"
#include "command/campaign/campaign_options.hpp"
#include "command/campaign/campaign_page.hpp"
#include "command/campaign/campaign_report.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "command/subcommands.hpp"
#include "fuzz/campaign/finding_folder.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct CampaignOptions {
  SubjectOptions subject;
  std::uint64_t seed = 0;
  std::optional<double> seconds;
  std::optional<std::size_t> cases;
  std::vector<std::string> families;
  std::vector<std::string> excluded;
  Sizes sizes;
  std::string known;
  bool goes_on = false;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string folder = "campaign";
  std::string corpus;
  std::string junit;
  std::string sarif;
  bool annotates = false;
  std::string html;
  OutputOptions output;
};

std::string join(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

// Whatever changes the cases or what is found in them.
campaign::Settings settings_of(const CampaignOptions& options, const campaign::Plan& plan) {
  const campaign::Subject& subject = plan.subject;
  std::vector<std::string> families;
  for (const campaign::Source& source : plan.sources) families.push_back(source.family);
  std::vector<std::string> corpus;
  for (const campaign::Replayed& replayed : plan.replayed) corpus.push_back(replayed.name);
  std::vector<std::string> refusals = subject.refusal_texts;
  for (const int code : subject.refusal_codes) refusals.push_back(std::to_string(code));
  std::vector<std::string_view> updates;
  for (const generators::UpdateKind kind : subject.updates) updates.push_back(name(kind));
  std::vector<std::string_view> untidiness;
  for (const generators::Untidiness kind : options.subject.untidiness)
    untidiness.push_back(name(kind));
  std::vector<std::string_view> relations;
  for (const generators::Relation relation : subject.relations) relations.push_back(name(relation));
  return {{"command", campaign::command_line(subject)},
          {"--claim", std::string(name(subject.claim))},
          {"--seed", std::to_string(plan.seed)},
          {"--families", join(families)},
          {"--max-points", options.sizes.max_points ? std::to_string(*options.sizes.max_points)
                                                    : "20, of some 2000"},
          {"--exponents", magnitudes(options.sizes)},
          {"--known", join(plan.known)},
          {"--corpus", join(corpus)},
          {"--dimension", std::to_string(subject.dimension)},
          {"--fill",
           std::string(name(subject.fill)) + (subject.merges_coplanar ? " --merge-coplanar" : "")},
          {subject.is_about_domains() ? "--domain" : "--points",
           subject.input_name + (subject.reads_stdin ? " on stdin" : "")},
          {"--mesh", subject.mesh_name + (subject.writes_stdout ? " on stdout" : "")},
          {"--worker", subject.talk ? fmt::format("{} cases", subject.talk->cases) : "no"},
          {"--updates", fmt::format("{}", fmt::join(updates, ","))},
          {"--metamorphic", fmt::format("{}", fmt::join(relations, ","))},
          {"--untidy", fmt::format("{}", fmt::join(untidiness, ","))},
          {"--against", join(subject.against)},
          {"--first-index", std::to_string(subject.first_index)},
          {"--full-dimension", subject.full_dimension ? "yes" : "no"},
          {"refusals", join(refusals)},
          {"limits", fmt::format("{} s, {} bytes of memory, {} of output, {} processes",
                                 subject.limits.seconds, subject.limits.memory,
                                 subject.limits.output, subject.limits.processes)}};
}

// What is happening, on standard error: how the time is shared out, when the making small goes on alone,
// and on a terminal one line that is written over and over.
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

// What a campaign would write over something that it reads; empty if nothing.
std::string overwriting_fault_of(const CampaignOptions& options, const campaign::Plan& plan) {
  std::vector<Written> written = {{"the journal", plan.output + "/journal.tsv"}};
  for (const std::string& report : {options.junit, options.sarif}) {
    if (!report.empty()) written.push_back({"the report", report});
  }
  if (!options.html.empty()) written.push_back({"the page", options.html});
  std::vector<std::string> read = plan.subject.command;
  const std::string findings = campaign::findings_folder(plan.output);
  for (const campaign::Replayed& replayed : plan.replayed) {
    read.push_back(replayed.name);
    if (!lies_in(replayed.name, findings)) continue;
    return fmt::format(
        "expected another name for the folder of --output, found {}, among whose findings {} is "
        "read",
        options.folder, replayed.name);
  }
  for (const std::string& report : {options.junit, options.sarif}) {
    if (report.empty() || !lies_in(report, findings)) continue;
    return fmt::format("expected another name for the report, found {}, among the findings",
                       report);
  }
  if (!options.html.empty() && lies_in(options.html, findings)) {
    return fmt::format("expected another name for the page, found {}, among the findings",
                       options.html);
  }
  return overwriting_fault(written, read);
}

// The first words of the lines of a file; what stands behind #, and empty lines, are left out.
tl::expected<std::vector<std::string>, std::string> known_signatures(const std::string& path) {
  const formats::Result<formats::Source> source = formats::load(path);
  if (!source) return tl::unexpected(source.error().to_string());
  std::istringstream file(source->text);
  std::vector<std::string> known;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string signature;
    if (words >> signature) known.push_back(signature);
  }
  if (known.empty()) {
    return tl::unexpected(path + ": expected a file with a signature on each line, found none");
  }
  return known;
}

// Reads LOW:HIGH. What is wrong with it, or an empty string.
std::string read_exponents(const std::string& text, generators::Exponents& exponents) {
  constexpr int kLeast = -1074;
  constexpr int kLargest = 1023;
  std::istringstream numbers(text);
  char colon = 0;
  const bool is_read = numbers >> exponents.least >> colon >> exponents.largest && colon == ':' &&
                       numbers.peek() == std::istringstream::traits_type::eof();
  if (is_read && kLeast <= exponents.least && exponents.least < exponents.largest &&
      exponents.largest <= kLargest) {
    return "";
  }
  return fmt::format("expected LOW:HIGH, two integers from {} to {} in ascending order, found {}",
                     kLeast, kLargest, text);
}

// What is to be done; errors are printed.
tl::expected<campaign::Plan, ExitCode> plan_of(const CampaignOptions& options) {
  const auto fault = [](const std::string& message, ExitCode code) {
    usage_error(message);
    return tl::unexpected(code);
  };
  bool not_found = false;
  auto subject = subject_of(options.subject, not_found);
  if (!subject) {
    return fault(subject.error(), not_found ? ExitCode::kInputFault : ExitCode::kUsage);
  }
  campaign::Plan plan;
  plan.subject = std::move(*subject);
  Sizes sizes = options.sizes;
  sizes.untidiness.insert(options.subject.untidiness.begin(), options.subject.untidiness.end());
  auto sources = campaign_sources(plan.subject, options.families, options.excluded, sizes);
  if (!sources) return fault(sources.error(), ExitCode::kUsage);
  plan.sources = std::move(*sources);
  if (!options.corpus.empty()) {
    auto replayed = campaign_corpus(plan.subject, options.corpus);
    if (!replayed) return fault(replayed.error(), ExitCode::kInputFault);
    plan.replayed = std::move(*replayed);
  }
  if (!options.known.empty()) {
    auto known = known_signatures(options.known);
    if (!known) return fault(known.error(), ExitCode::kInputFault);
    plan.known = std::move(*known);
  }
  if (options.sizes.integers && plan.subject.is_about_domains()) {
    return fault("expected no --integers for domains, found one", ExitCode::kUsage);
  }
  if (!plan.subject.is_about_domains()) plan.magnitudes = magnitudes(options.sizes);
  plan.seed = options.seed;
  plan.cases = options.cases;
  plan.seconds = options.seconds;
  if (!plan.cases && !plan.seconds) plan.seconds = 60;
  plan.jobs = options.jobs;
  plan.goes_on = options.goes_on;
  plan.output = std::filesystem::absolute(options.folder).lexically_normal().string();
  plan.minimise = options.subject.minimise();
  plan.settings = settings_of(options, plan);
  const std::string overwriting = overwriting_fault_of(options, plan);
  if (!overwriting.empty()) return fault(overwriting, ExitCode::kUsage);
  return plan;
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
  add_subject_options(*command, options->subject);
  command
      ->add_option("--seed", options->seed,
                   "The seed of all inputs: the same seed draws the same inputs (default: 0)")
      ->check(whole_number())
      ->option_text("N");
  add_duration(
      *command, "--time", options->seconds,
      "Stop after TIME, of which up to a quarter goes into minimizing findings. The campaign "
      "waits for programs that still run (default: 60s; with --cases, until all are done)");
  command
      ->add_option("--cases", options->cases,
                   "Draw N inputs, in all runs of this campaign together")
      ->check(whole_number())
      ->option_text("N");
  command
      ->add_option(
          "--families", options->families,
          "The families to draw from, with commas between them (default: all families; 'all': "
          "all families with all modifiers). circumspect generate --list names them. Modifiers "
          "can be combined, as in grid+moved+ulp")
      ->delimiter(',')
      ->option_text("NAME,...");
  command
      ->add_option(
          "--max-points", options->sizes.max_points,
          "The largest number of points of an input (default: 20; in dimensions up to 3, a few "
          "per cent of the point sets have 64 to 2000)")
      ->check(whole_number(1, 1'000'000))
      ->option_text("N");
  command
      ->add_option("--exclude", options->excluded,
                   "Families to leave out with all their modifiers, with commas between them")
      ->delimiter(',')
      ->option_text("NAME,...");
  CLI::Option* const exponents =
      command
          ->add_option_function<std::string>(
              "--exponents",
              [options](const std::string& text) {
                const std::string fault = read_exponents(text, options->sizes.exponents);
                if (!fault.empty()) throw CLI::ValidationError("--exponents", fault);
              },
              "Coordinates other than 0 lie between 2^LOW and 2^HIGH in absolute value "
              "(default: -100:100). Write it with =, as in --exponents=-20:20")
          ->option_text("LOW:HIGH");
  command
      ->add_flag(
          "--extreme", options->sizes.extreme,
          "Draw coordinates as large and as small as the families have them: up to 2^990, down "
          "to 2^-1000 and to denormal numbers. The signature of a finding that needs such "
          "numbers ends in -extreme")
      ->excludes(exponents);
  command
      ->add_option(
          "--integers", options->sizes.integers,
          "Draw coordinates and weights that are integers, and coordinates of at most BITS bits")
      ->check(whole_number(1, 53))
      ->option_text("BITS");
  command
      ->add_option(
          "--known", options->known,
          "A file with a signature on each line. Cases with these signatures are counted, but "
          "are not findings. A # begins a comment")
      ->option_text("FILE");
  command
      ->add_option("--corpus", options->corpus, "First try all inputs in the files of this folder")
      ->option_text("FOLDER");
  command->add_flag("--go-on", options->goes_on,
                    "Go on where the program fails on each of the first ten inputs. Without it, "
                    "the campaign then "
                    "asks whether the command is right, keeps nothing and ends with exit code 3");
  command
      ->add_option("--jobs", options->jobs,
                   "Run N programs at a time (default: one for each processor)")
      ->check(whole_number(1, 256))
      ->option_text("N");
  command
      ->add_option(
          "--output", options->folder,
          "The folder of the journal. Findings go to FOLDER/findings, or to FOLDER itself if its "
          "name is findings (default: campaign)")
      ->option_text("FOLDER");
  command
      ->add_option("--about", options->subject.about,
                   "The version of the program and how it was built, for issue.md of each finding; "
                   "such as --about \"$(my_program --version), built by make\"")
      ->option_text("TEXT");
  command
      ->add_option(
          "--promise", options->subject.promise,
          "A promise from the program's documents, quoted and with its address, for issue.md of "
          "each finding")
      ->option_text("TEXT");
  command->add_option("--junit", options->junit, "Also write a report for CI")->option_text("FILE");
  command->add_option("--sarif", options->sarif, "Also write a report for code scanning (SARIF)")
      ->option_text("FILE");
  command->add_flag("--annotations", options->annotates,
                    "Also print a line for each finding that GitHub Actions shows as an error");
  command
      ->add_option(
          "--html", options->html,
          "Also write a page that shows each finding as a picture; it opens in any browser, "
          "without a network")
      ->option_text("FILE");
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
