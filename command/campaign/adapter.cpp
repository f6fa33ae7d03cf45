// circumspect adapter LANGUAGE
// A worker to begin with, for those who let a campaign talk to one.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command/options/one_of.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"

namespace circumspect::cli {

// The texts of fuzz/adapters, by the extensions of their names: ".py". command/CMakeLists.txt
// writes them.
const std::map<std::string, std::string>& adapters();

void add_adapter(CLI::App& app, ExitCode& exit_code) {
  const auto language = std::make_shared<std::string>();
  const auto has_updates = std::make_shared<bool>(false);
  static const std::map<std::string, std::string> extensions = {
      {"c", ".c"},       {"c++", ".cpp"},        {"go", ".go"},
      {"java", ".java"}, {"javascript", ".mjs"}, {"julia", ".jl"},
      {"octave", ".m"},  {"python", ".py"},      {"r", ".R"},
      {"rust", ".rs"}};
  CLI::App* command =
      app.add_subcommand("adapter", "Print a short program that lets a campaign talk to a library");
  command->footer(
      "Examples:\n"
      "  circumspect adapter python > mine.py\n"
      "  circumspect adapter python --updates > mine.py\n"
      "  circumspect campaign --worker --dimension 2 -- python3 mine.py\n"
      "\n"
      "One function of this program calls the library: call yours there. docs/workers.md "
      "describes the\n"
      "lines that it reads and writes.\n"
      "\n"
      "Exit codes: 0 printed, 2 usage, 5 internal error.");
  std::vector<std::string> languages;
  for (const auto& [name, extension] : extensions) languages.push_back(name);
  command->add_option("language", *language, "The language of the library")
      ->required()
      ->check(one_of_words(languages))
      ->option_text("c|c++|go|java|javascript|julia|octave|python|r|rust");
  command->add_flag(
      "--updates", *has_updates,
      "Print the adapter for campaign --updates, whose library inserts and deletes points "
      "(python only)");
  command->callback([language, has_updates, &exit_code] {
    const auto adapter =
        adapters().find((*has_updates ? ".updates" : "") + extensions.at(*language));
    if (adapter == adapters().end()) {
      exit_code = usage_error("expected python with --updates, found " + *language);
      return;
    }
    Output output{OutputOptions{}};
    output.text(adapter->second);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
