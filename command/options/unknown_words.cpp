#include "command/options/unknown_words.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/nearest_word.hpp"

namespace circumspect::cli {
namespace {

using Words = std::vector<std::string>;

std::vector<const CLI::App*> subcommands(const CLI::App& command) {
  // Those without a group are for the build, not for people.
  return command.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

Words names_of(const std::vector<const CLI::App*>& commands) {
  Words names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

Words options_of(const CLI::App& command) {
  Words words;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    for (const std::string& name : option->get_snames()) words.push_back("-" + name);
  }
  return words;
}

// "circumspect build cdt"
std::string whole_name(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return (parent == nullptr ? "" : whole_name(*parent) + " ") + command.get_name();
}

// The commands below this one that have an option of this name.
void add_commands_with(const std::string& option, const CLI::App& command, Words& found) {
  for (const CLI::App* one : subcommands(command)) {
    const Words options = options_of(*one);
    if (std::find(options.begin(), options.end(), option) != options.end()) {
      found.push_back(whole_name(*one));
    }
    add_commands_with(option, *one, found);
  }
}

const CLI::App& root_of(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return parent == nullptr ? command : root_of(*parent);
}

std::string option_text(const CLI::App& command, const std::string& word) {
  const std::string option = word.substr(0, word.find('='));
  Words others;
  add_commands_with(option, root_of(command), others);
  if (!others.empty() && others.size() <= 3) {
    return fmt::format("{}: expected one of its options, found {}, an option of {}",
                       whole_name(command), option, fmt::join(others, ", "));
  }
  if (!others.empty()) {
    return fmt::format("{}: expected one of its options, found {}, an option of {} and others",
                       whole_name(command), option, others.front());
  }
  return fmt::format("{}: expected one of its options, found {}{}", whole_name(command), option,
                     nearest_text(option, options_of(command)));
}

std::string argument_text(const CLI::App& command, const std::string& word) {
  const Words names = names_of(subcommands(command));
  if (names.empty()) {
    return fmt::format("{}: expected no further argument, found {}", whole_name(command), word);
  }
  return fmt::format("{}: expected {}, found {}{}", whole_name(command), fmt::join(names, "|"),
                     word, nearest_text(word, names));
}

// What was expected where nothing was found, if it is a subcommand.
std::string missing_text(const CLI::App& command) {
  if (command.get_require_subcommand_min() == 0 || !command.get_subcommands().empty()) return "";
  return fmt::format("{}: expected {}, found none", whole_name(command),
                     fmt::join(names_of(subcommands(command)), "|"));
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-' && word != "--";
}

// The option among the words that are left over. Where a subcommand was expected all words behind the first
// are about that.
std::optional<std::string> left_over_option(const CLI::App& command) {
  Words words = command.remaining();
  if (!words.empty() && !subcommands(command).empty()) words.resize(1);
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  return option == words.end() ? std::nullopt : std::optional(*option);
}

}  // namespace

std::string unknown_word_text(const CLI::App& app) {
  // From the outermost to the innermost, such as `circumspect`, `build`, `cdt`.
  std::vector<const CLI::App*> chain = {&app};
  while (!chain.back()->get_subcommands().empty()) {
    chain.push_back(chain.back()->get_subcommands().back());
  }
  // An option that is none leaves its value over, too, which the commands around may be given.
  for (auto command = chain.rbegin(); command != chain.rend(); ++command) {
    if (const auto option = left_over_option(**command)) return option_text(**command, *option);
  }
  for (const CLI::App* command : chain) {
    const Words words = command->remaining();
    if (!words.empty()) return argument_text(*command, words.front());
  }
  return missing_text(*chain.back());
}

}  // namespace circumspect::cli
