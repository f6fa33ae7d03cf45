#include "command/options/help.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string_view>

#include <CLI/CLI.hpp>

#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "platform/files.hpp"
#include "platform/terminal.hpp"

namespace circumspect::cli {

std::vector<const CLI::App*> shown_subcommands(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

std::string value_name(const CLI::Option& option) {
  if (!option.get_option_text().empty()) return option.get_option_text();
  return option.get_items_expected_max() == 0 ? "" : option.get_type_name();
}

namespace {

struct Group {
  const char* title;
  std::vector<std::string_view> options;
};

// An option means much the same wherever it is.
const std::vector<Group>& groups() {
  static const std::vector<Group> all = {
      {"Claim", {"claim",        "weighted", "oriented", "manifold",          "connected",
                 "closed",       "faces",    "allow",    "allow-unused",      "all-boundary-points",
                 "only-extreme", "box",      "lattice",  "require",           "except-sharp",
                 "neighbors",    "by",       "against",  "refusal-exit-code", "refusal-text"}},
      {"Domain", {"domain", "fill", "hole", "region", "resolve", "merge-coplanar", "within"}},
      {"Input",
       {"points", "points-a", "points-b", "mesh", "stdin", "stdout", "worker", "worker-cases",
        "first-index", "coordinates", "duplicates", "drop", "keep-label", "allow-empty"}},
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
  if (option.get_group() == "Input") return;  // the same name means another thing elsewhere
  option.group("Options");
  for (const Group& group : groups()) {
    for (const std::string& name : option.get_lnames()) {
      const auto& names = group.options;
      if (std::find(names.begin(), names.end(), name) != names.end()) option.group(group.title);
    }
  }
}

// How many characters fit a line: what COLUMNS says, or the terminal, or as many as any terminal
// has.
std::size_t width() {
  constexpr std::size_t kUsual = 80;
  const char* const columns = std::getenv("COLUMNS");
  std::size_t count = 0;
  if (columns != nullptr) {
    const std::string_view text = columns;
    std::from_chars(text.data(), text.data() + text.size(), count);
  }
  if (count == 0) count = platform::terminal_width(platform::kStandardOutput);
  return count == 0 ? kUsual : count;
}

// Breaks each line between words, as far as that can be, so that none is longer. Lines that begin
// with a blank, which are examples, stay as they are.
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

// One line for each paragraph of a text whose lines are broken; examples, which begin with a blank,
// stay as they are.
std::string with_lines_joined(const std::string& text) {
  std::string joined;
  bool in_paragraph = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool goes_on = !line.empty() && line.front() != ' ';
    joined += in_paragraph && goes_on ? " " : joined.empty() ? "" : "\n";
    joined += line;
    in_paragraph = goes_on && line.back() != ':';
  }
  return joined;
}

// Lays --help out. CLI11's own formatter would do, but that it does so differently in each of its
// versions.
class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode /*mode*/) const override {
    std::string text = wrapped(command->get_description(), width()) + "\n" + usage(*command, name);
    text += group("Positionals", positionals(*command));
    for (const std::string& title : command->get_groups()) {
      text += group(title, command->get_options([&title](const CLI::Option* option) {
        return option->nonpositional() && option->get_group() == title;
      }));
    }
    std::string rows;
    for (const CLI::App* one : shown_subcommands(*command)) {
      rows += row(one->get_name(), one->get_description());
    }
    if (!rows.empty()) text += "\nSubcommands:\n" + rows;
    return text + "\n" + wrapped(with_lines_joined(command->get_footer()), width()) + "\n";
  }

 private:
  using Options = std::vector<const CLI::Option*>;

  static Options positionals(const CLI::App& command) {
    return command.get_options([](const CLI::Option* one) { return one->get_positional(); });
  }

  // "mesh...", or "[family]" if it may be left out.
  static std::string positional_name(const CLI::Option& option) {
    const std::string name =
        option.get_single_name() + (option.get_items_expected_max() > 1 ? "..." : "");
    return option.get_required() ? name : "[" + name + "]";
  }

  static std::string usage(const CLI::App& command, const std::string& name) {
    std::string text = "Usage: " + name + " [OPTIONS]";
    for (const CLI::Option* one : positionals(command)) text += " " + positional_name(*one);
    if (!shown_subcommands(command).empty()) text += " SUBCOMMAND";
    return text + "\n";
  }

  // What stands on the left of an option: its names, and what its value is called.
  static std::string names(const CLI::Option& option) {
    const std::string name =
        option.get_positional() ? positional_name(option) : option.get_name(false, true);
    const std::string value =
        option.get_positional() ? option.get_option_text() : value_name(option);
    // CLI11 shows in braces what a flag means without its value.
    if (const std::size_t brace = name.find('{'); brace != std::string::npos) {
      return name.substr(0, brace) + value;
    }
    return name + (value.empty() ? "" : " " + value);
  }

  static std::string row(const std::string& left, const std::string& right) {
    std::string text = "  " + left;
    text += text.size() < kLeft ? std::string(kLeft - text.size(), ' ')
                                : "\n" + std::string(kLeft, ' ');
    std::istringstream lines(wrapped(right, beside_names()));
    bool is_first = true;
    for (std::string line; std::getline(lines, line); is_first = false) {
      text += (is_first ? "" : "\n" + std::string(kLeft, ' ')) + line;
    }
    return text + "\n";
  }

  static std::string group(const std::string& title, const Options& options) {
    std::string rows;
    for (const CLI::Option* option : options)
      rows += row(names(*option), option->get_description());
    return rows.empty() || title.empty() ? "" : "\n" + title + ":\n" + rows;
  }

  // What stands beside the names of the options has some room on any terminal.
  static std::size_t beside_names() {
    constexpr std::size_t kLeast = 20;
    return std::max(kLeast, width() - std::min(width(), kLeft));
  }

  static constexpr std::size_t kLeft = 30;
};

void lay_out(CLI::App& command, const std::shared_ptr<HelpFormatter>& formatter) {
  command.formatter(formatter);
  for (CLI::Option* option : command.get_options()) put_into_group(*option);
  for (CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; }))
    lay_out(*one, formatter);
}

}  // namespace

void lay_out_help(CLI::App& app) { lay_out(app, std::make_shared<HelpFormatter>()); }

}  // namespace circumspect::cli
