#include "command/options/words.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/help.hpp"
#include "command/options/nearest_word.hpp"

namespace circumspect::cli {

std::string whole_name(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return (parent == nullptr ? "" : whole_name(*parent) + " ") + command.get_name();
}

namespace {

using Words = std::vector<std::string>;

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

// Whoever forgets a value would have the next option in its place: a page named --color.
void refuse_as_values(CLI::Option& option, const std::shared_ptr<const Words>& options) {
  option.check([options, expected = value_name(option)](const std::string& value) {
    const bool is_one = std::find(options->begin(), options->end(), value) != options->end();
    return is_one ? fmt::format("expected {}, found the option {}", expected, value) : "";
  });
}

// The commands below this one that have an option of this name.
void add_commands_with(const std::string& option, const CLI::App& command, Words& found) {
  for (const CLI::App* one : shown_subcommands(command)) {
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
  const Words names = names_of(shown_subcommands(command));
  if (names.empty()) {
    return fmt::format("{}: expected no further argument, found {}", whole_name(command), word);
  }
  return fmt::format("{}: expected {}, found {}{}", whole_name(command), fmt::join(names, "|"),
                     word, nearest_text(word, names));
}

// What was expected where nothing was found: an argument or an option that must be there, or a
// subcommand.
std::string missing_text(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    const std::string kind = option->nonpositional() ? "the option " : "the argument ";
    return fmt::format("{}: expected {}{}, found none", whole_name(command), kind,
                       option->get_name());
  }
  if (command.get_require_subcommand_min() == 0 || !command.get_subcommands().empty()) return "";
  return fmt::format("{}: expected {}, found none", whole_name(command),
                     fmt::join(names_of(shown_subcommands(command)), "|"));
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-' && word != "--";
}

// The option among the words that are left over. Where a subcommand was expected all words behind
// the first are about that.
std::optional<std::string> left_over_option(const CLI::App& command) {
  Words words = command.remaining();
  if (!words.empty() && !shown_subcommands(command).empty()) words.resize(1);
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  return option == words.end() ? std::nullopt : std::optional(*option);
}

// From the outermost to the innermost, such as `circumspect`, `build`, `cdt`.
std::vector<const CLI::App*> called_commands(const CLI::App& app) {
  std::vector<const CLI::App*> chain = {&app};
  while (!chain.back()->get_subcommands().empty()) {
    chain.push_back(chain.back()->get_subcommands().back());
  }
  return chain;
}

// The option whose name a message of CLI11's begins with; some leave out the hyphens.
const CLI::Option* option_of(const CLI::App& command, const std::string& message) {
  const std::string name = message.substr(0, message.find_first_of(": "));
  const std::string bare = name.substr(std::min(name.find_first_not_of('-'), name.size()));
  const auto has_it = [&bare](const Words& names) {
    return std::find(names.begin(), names.end(), bare) != names.end();
  };
  const auto options = command.get_options([&has_it](const CLI::Option* one) {
    return has_it(one->get_lnames()) || has_it(one->get_snames());
  });
  return options.empty() ? nullptr : options.front();
}

}  // namespace

void deal_words_to_options(CLI::App& app) {
  const auto options = std::make_shared<const Words>(options_of(app));
  for (CLI::Option* option : app.get_options()) {
    if (option->nonpositional()) option->allow_extra_args(false);
    // --merge-coplanar reads what stands behind its = itself.
    const bool is_flag = option->get_items_expected_max() == 0 && option->get_type_name().empty();
    // A flag that may have a value shows which (--oriented[=same|positive|negative]).
    const bool may_have_value = !option->get_option_text().empty();
    if (is_flag && !may_have_value) option->disable_flag_override();
    if (option->nonpositional() && !is_flag) refuse_as_values(*option, options);
  }
  for (CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    deal_words_to_options(*one);
}

std::string unknown_word_text(const CLI::App& app) {
  const std::vector<const CLI::App*> chain = called_commands(app);
  // An option that is none leaves its value over, too, which the commands around may be given.
  for (auto command = chain.rbegin(); command != chain.rend(); ++command) {
    if (const auto option = left_over_option(**command)) return option_text(**command, *option);
  }
  for (const CLI::App* command : chain) {
    const Words words = command->remaining();
    // Behind a subcommand, a word is no longer meant as another one.
    if (!words.empty()) return argument_text(*chain.back(), words.front());
  }
  return missing_text(*chain.back());
}

std::string value_text(const CLI::App& app, const std::string& message) {
  const CLI::App& command = *called_commands(app).back();
  const CLI::Option* const option = option_of(command, message);
  if (option == nullptr) return "";
  if (option->get_items_expected_max() == 0) {
    return fmt::format("{}: expected no value for {}, found one", whole_name(command),
                       option->get_name());
  }
  return fmt::format("{}: expected {} after {}, found none", whole_name(command),
                     value_name(*option), option->get_name());
}

const CLI::App* named_command(const CLI::App& app, const std::vector<std::string>& words,
                              std::string& fault) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    const auto below = shown_subcommands(*command);
    const auto found = std::find_if(below.begin(), below.end(),
                                    [&](const CLI::App* one) { return one->get_name() == word; });
    if (found == below.end()) {
      fault = argument_text(*command, word);
      return nullptr;
    }
    command = *found;
  }
  return command;
}

}  // namespace circumspect::cli
