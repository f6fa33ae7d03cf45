#include "command/options/help.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "command/options/nearest_word.hpp"

namespace circumspect::cli {

namespace {

struct Group {
  const char* title;
  std::vector<std::string_view> options;
};

// An option means much the same wherever it is.
const std::vector<Group>& groups() {
  static const std::vector<Group> all = {
      {"Claim",
       {"claim", "weighted", "oriented", "manifold", "connected", "closed", "allow", "allow-unused",
        "neighbors", "by", "against", "refusal-exit-code", "refusal-text"}},
      {"Domain", {"domain", "fill", "hole", "region", "merge-coplanar", "within"}},
      {"Input",
       {"points", "mesh", "stdin", "stdout", "worker", "worker-cases", "first-index", "coordinates",
        "duplicates", "keep-label", "allow-empty"}},
      {"Drawn inputs",
       {"seed", "families", "exclude", "exponents", "extreme", "integers", "known", "max-points",
        "cases", "corpus", "dimension", "full-dimension", "metamorphic", "untidy", "updates",
        "list", "count", "fewer"}},
      {"Construction",
       {"algorithm", "order", "location", "statistics", "some-points", "steiner-points"}},
      {"Facts",
       {"subsets", "simplex", "only", "all-segments", "decide", "search-vertices",
        "search-conflicts"}},
      {"Limits",
       {"threads", "memory", "limit", "time", "jobs", "go-on", "limit-time", "limit-memory",
        "limit-output", "limit-processes", "limit-judging", "containment", "minimize-time",
        "minimize-runs"}},
      {"Output",
       {"output", "certificate", "refutations", "html", "vtu", "junit", "sarif", "annotations",
        "about", "promise", "max-errors", "format", "color", "quiet"}},
  };
  return all;
}

void put_into_group(CLI::Option& option) {
  for (const Group& group : groups()) {
    for (const std::string& name : option.get_lnames()) {
      const auto& names = group.options;
      if (std::find(names.begin(), names.end(), name) != names.end()) option.group(group.title);
    }
  }
}

// How many characters fit a line.
std::size_t width() {
  const char* const columns = std::getenv("COLUMNS");
  std::size_t count = 0;
  if (columns != nullptr) {
    const std::string_view text = columns;
    std::from_chars(text.data(), text.data() + text.size(), count);
  }
  winsize size{};
  if (count == 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) count = size.ws_col;
  return count == 0 ? std::numeric_limits<std::size_t>::max() : count;
}

// Breaks each line between words, as far as that can be, so that none is longer. Lines that begin with a blank, which
// are examples, stay as they are.
std::string wrapped(const std::string& text, std::size_t longest) {
  std::string broken;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!broken.empty()) broken += '\n';
    while (line.size() > longest && line.front() != ' ') {
      std::size_t end = line.rfind(' ', longest);
      if (end == std::string::npos) end = line.find(' ');
      if (end == std::string::npos) break;
      broken += line.substr(0, end) + '\n';
      line.erase(0, end + 1);
    }
    broken += line;
  }
  return broken;
}

class HelpFormatter : public CLI::Formatter {
 public:
  // One blank line between two groups, not two.
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode mode) const override {
    return CLI::detail::find_and_replace(CLI::Formatter::make_help(command, name, mode), "\n\n\n",
                                         "\n\n");
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(CLI::Formatter::make_option_desc(option), beside_names());
  }
  std::string make_subcommand(const CLI::App* command) const override {
    std::ostringstream text;
    CLI::detail::format_help(text, command->get_name(),
                             wrapped(command->get_description(), beside_names()),
                             get_column_width());
    return text.str();
  }
  std::string make_description(const CLI::App* command) const override {
    return wrapped(CLI::Formatter::make_description(command), width()) + "\n";
  }
  std::string make_footer(const CLI::App* command) const override {
    return wrapped(CLI::Formatter::make_footer(command), width()) + "\n";
  }

 private:
  // What stands beside the names of the options has some room on any terminal.
  std::size_t beside_names() const {
    constexpr std::size_t kLeast = 20;
    return std::max(kLeast, width() - std::min(width(), get_column_width()));
  }
};

void lay_out(CLI::App& command, const std::shared_ptr<HelpFormatter>& formatter) {
  command.formatter(formatter);
  for (CLI::Option* option : command.get_options()) put_into_group(*option);
  for (CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; }))
    lay_out(*one, formatter);
}

}  // namespace

void lay_out_help(CLI::App& app) { lay_out(app, std::make_shared<HelpFormatter>()); }

void let_options_take_one_word(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->nonpositional()) option->allow_extra_args(false);
  }
  for (CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    let_options_take_one_word(*one);
}

// ---- Unknown words ----
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

// What was expected where nothing was found: an argument or an option that must be there, or a subcommand.
std::string missing_text(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    const std::string kind = option->nonpositional() ? "the option " : "the argument ";
    return fmt::format("{}: expected {}{}, found none", whole_name(command), kind,
                       option->get_name());
  }
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
