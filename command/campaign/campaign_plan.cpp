#include "command/campaign/campaign_plan.hpp"

#include <filesystem>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/campaign/subject.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/quantity.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/overwriting.hpp"
#include "fuzz/campaign/finding_folder.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::cli {
namespace {

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

std::vector<OptionRow> rows_of(CampaignOptions& options) {
  return {
      {"--seed", "N", into(options.seed, whole_number()),
       "The seed of all inputs: the same seed draws the same inputs (default: 0)"},
      {"--time", "TIME", duration(options.seconds),
       "Stop after TIME; up to a quarter of it goes into minimizing findings. The campaign "
       "waits for programs that still run (default: 60s; with --cases, until all are done)"},
      {"--cases", "N", into(options.cases, whole_number()),
       "Draw N inputs, in all runs of this campaign together"},
      {"--families", "NAME,...", listed(options.families),
       "The families to draw from, with commas between them (default: all families; 'all': all "
       "families with all modifiers). circumspect generate --list names them. Modifiers can be "
       "combined, as in grid+moved+ulp"},
      {"--max-points", "N", into(options.sizes.max_points, whole_number(1, 1'000'000)),
       "The largest number of points of an input (default: 20; in dimensions up to 3, a few per "
       "cent of the point sets have 64 to 2000)"},
      {"--exclude", "NAME,...", listed(options.excluded),
       "Families to leave out with all their modifiers, with commas between them"},
      {"--exponents", "LOW:HIGH",
       read_by([&place = options.sizes.exponents](const std::string& text) {
         return read_exponents(text, place);
       }),
       "Coordinates other than 0 lie between 2^LOW and 2^HIGH in absolute value (default: "
       "-100:100). Write it with =, as in --exponents=-20:20"},
      {"--extreme", "", flag(options.sizes.extreme),
       "Draw coordinates as large and as small as the families have them: up to 2^990, down to "
       "2^-1000 and to denormal numbers. The signature of a finding that needs such numbers ends "
       "in -extreme",
       "--exponents"},
      {"--integers", "BITS", into(options.sizes.integers, whole_number(1, 53)),
       "Draw coordinates and weights that are integers, and coordinates of at most BITS bits"},
      {"--known", "FILE", into(options.known),
       "A file with a signature on each line. Cases with these signatures are counted, but are "
       "not findings. A # begins a comment"},
      {"--corpus", "FOLDER", into(options.corpus),
       "First try all inputs in the files of this folder"},
      {"--go-on", "", flag(options.goes_on),
       "Go on where the program fails on each of the first ten inputs. Without it, the campaign "
       "then asks whether the command is right, keeps nothing and ends with exit code 3"},
      {"--jobs", "N", into(options.jobs, whole_number(1, 256)),
       "Run N programs at a time (default: one for each processor)"},
      {"--output", "FOLDER", into(options.folder),
       "The folder of the journal. Findings go to FOLDER/findings, or to FOLDER itself if its "
       "name is findings (default: campaign)"},
      {"--about", "TEXT", into(options.subject.about),
       "The version of the program and how it was built, for issue.md of each finding; such as "
       "--about \"$(my_program --version), built by make\""},
      {"--promise", "TEXT", into(options.subject.promise),
       "A promise from the program's documents, quoted and with its address, for issue.md of "
       "each finding"},
      {"--junit", "FILE", into(options.junit), "Also write a report for CI"},
      {"--sarif", "FILE", into(options.sarif), "Also write a report for code scanning (SARIF)"},
      {"--annotations", "", flag(options.annotates),
       "Also print a line for each finding that GitHub Actions shows as an error"},
      {"--html", "FILE", into(options.html),
       "Also write a page that shows each finding as a picture; it opens in any browser, without "
       "a network"}};
}

}  // namespace

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

void add_campaign_options(CLI::App& command, CampaignOptions& options) {
  add_subject_options(command, options.subject);
  add_options(command, rows_of(options));
  add_output_options(command, options.output);
}

}  // namespace circumspect::cli
