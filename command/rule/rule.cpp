// circumspect rule [NAME]: what a rule means, what breaks it, and how to mend it.
#include "oracle/model/rule.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/nearest_word.hpp"
#include "command/output/output.hpp"
#include "command/rule/page_text.hpp"
#include "command/subcommands.hpp"
#include "kernel/piecewise_linear/breach_kind.hpp"

namespace circumspect::cli {
namespace {

struct RuleOptions {
  std::string identifier;
  OutputOptions output;
};

// A rule of meshes or a breach of Definition 4.3, as it is listed.
struct Listed {
  std::string identifier;
  std::string meaning;
  report::Json facts;
};

std::string judged_of(JudgedOf of) {
  switch (of) {
    case JudgedOf::kPoints:
      return "meshes of points";
    case JudgedOf::kDomains:
      return "meshes of a domain";
    case JudgedOf::kBoth:
      return "meshes of points or of a domain";
  }
  return "";
}

std::vector<Listed> rules_of_meshes() {
  std::vector<Listed> all;
  for (const RuleEntry& entry : rules()) {
    all.push_back({std::string(entry.identifier),
                   std::string(entry.meaning),
                   {{"rule", entry.identifier},
                    {"number", static_cast<int>(entry.rule)},
                    {"of", judged_of(entry.of)},
                    {"stage", name(entry.stage)},
                    {"meaning", entry.meaning},
                    {"theorem", fmt::format("docs/{}", entry.theorem)}}});
    if (!entry.unproved.empty()) all.back().facts["unproved"] = entry.unproved;
  }
  return all;
}

std::vector<Listed> breaches_of_domains() {
  std::vector<Listed> all;
  for (const BreachEntry& entry : breach_kinds()) {
    all.push_back({std::string(entry.identifier),
                   std::string(entry.meaning),
                   {{"rule", entry.identifier},
                    {"number", static_cast<int>(entry.kind)},
                    {"of", "domains"},
                    {"meaning", entry.meaning},
                    {"theorem", "docs/theory/decisions.md#piecewise-linear-complexes"}}});
  }
  return all;
}

void print_list(const std::string& title, const std::vector<Listed>& list, const Output& output) {
  std::string text = title + "\n";
  for (const Listed& one : list) {
    text += fmt::format("  {:<30}  {}\n", one.identifier, one.meaning);
  }
  output.text(text);
}

ExitCode print_all(Output& output) {
  const std::vector<Listed> of_meshes = rules_of_meshes();
  const std::vector<Listed> of_domains = breaches_of_domains();
  if (output.wants_text()) {
    print_list("What a mesh can break:", of_meshes, output);
    print_list("What can be wrong with a domain:", of_domains, output);
    output.text("circumspect rule IDENTIFIER says what causes one of them, and how to mend it.\n");
  }
  for (const auto& list : {of_meshes, of_domains}) {
    for (const Listed& one : list) output.json(one.facts);
  }
  return output.finish();
}

// Also where the word before the dot is missing.
ExitCode unknown(const std::string& identifier, const std::vector<Listed>& all) {
  std::vector<std::string> whole;
  std::vector<std::string> without_kind;
  for (const Listed& one : all) {
    whole.push_back(one.identifier);
    without_kind.push_back(one.identifier.substr(one.identifier.find('.') + 1));
  }
  std::string nearest = nearest_word(identifier, whole);
  if (nearest.empty()) {
    const std::string found = nearest_word(identifier, without_kind);
    const auto at = std::find(without_kind.begin(), without_kind.end(), found);
    if (at != without_kind.end())
      nearest = whole[static_cast<std::size_t>(at - without_kind.begin())];
  }
  return usage_error(
      fmt::format("expected the identifier of a rule (circumspect rule lists them), found {}{}",
                  identifier, nearest.empty() ? "" : "; the nearest is " + nearest));
}

ExitCode print_one(const std::string& identifier, Output& output) {
  std::vector<Listed> all = rules_of_meshes();
  for (Listed& one : breaches_of_domains()) all.push_back(std::move(one));
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Listed& one) { return one.identifier == identifier; });
  if (found == all.end()) return unknown(identifier, all);
  const std::string page = page_text(rule_pages().at(identifier));
  if (output.wants_text()) output.text(page);
  found->facts["page"] = page;
  output.json(found->facts);
  return output.finish();
}

}  // namespace

void add_rule(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<RuleOptions>();
  CLI::App* command = app.add_subcommand(
      "rule",
      "Say what a rule means, what usually breaks it, and how to mend it; or list all rules");
  command->footer(
      "Examples:\n"
      "  circumspect rule\n"
      "  circumspect rule complex.overlap\n"
      "\n"
      "Exit codes: 0 printed, 2 usage, 5 internal error.");
  command
      ->add_option("identifier", options->identifier,
                   "A rule that a mesh broke, or what is wrong with a domain")
      ->option_text("IDENTIFIER");
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] {
    Output output(options->output);
    exit_code =
        options->identifier.empty() ? print_all(output) : print_one(options->identifier, output);
  });
}

}  // namespace circumspect::cli
