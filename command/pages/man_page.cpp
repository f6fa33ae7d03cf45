// One command as a page for man.
#include <algorithm>
#include <cctype>
#include <sstream>

#include <CLI/CLI.hpp>

#include "command/options/help.hpp"
#include "command/pages/command_pages.hpp"

namespace circumspect::cli {
namespace {

// Plain text in roff: backslashes and hyphens as they stand, no line that is taken for a request.
std::string roff(const std::string& text) {
  std::string escaped;
  bool at_begin = true;
  for (const char c : text) {
    if (at_begin && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
    at_begin = c == '\n';
  }
  return escaped;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

// The words that an option takes. A line may end after one of them where they are too long for it.
std::string words_of(const std::string& value) {
  constexpr std::size_t kFitsOnALine = 60;
  std::string text = italic(value);
  if (value.size() <= kFitsOnALine) return text;
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 1)) {
    text.insert(at + 1, "\\:");
  }
  return text;
}

std::vector<const CLI::Option*> positionals(const CLI::App& command) {
  return command.get_options([](const CLI::Option* one) { return one->get_positional(); });
}

bool may_be_many(const CLI::Option& option) { return option.get_items_expected_max() > 1; }

std::string synopsis(const CommandPath& path) {
  std::string text = ".B " + roff(path.joined(" ")) + "\n[\\fIOPTIONS\\fR]";
  for (const CLI::Option* one : positionals(*path.command)) {
    if (one->get_single_name() == "command") text += " \\-\\-";
    const std::string name =
        italic(one->get_single_name()) + (may_be_many(*one) ? "\\|.\\|.\\|." : "");
    text += one->get_required() ? " " + name : " [" + name + "]";
  }
  if (path.command->get_require_subcommand_min() > 0) text += " \\fISUBCOMMAND\\fR \\|.\\|.\\|.";
  return text + "\n";
}

// "-o, --output OUT" and what it is about.
std::string option_entry(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += bold("-" + name) + ", ";
  for (const std::string& name : option.get_lnames()) names += bold("--" + name) + ", ";
  names.resize(names.size() - 2);
  const std::string value = value_name(option);
  return ".TP\n" + names + (value.empty() ? "" : " " + words_of(value)) + "\n" +
         roff(option.get_description()) + "\n";
}

bool begins(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

// The footer of --help: examples as they stand, exit codes, and what else there is to know.
std::string footer_sections(const std::string& footer) {
  std::string examples;
  std::string exit_status;
  std::string notes;
  std::istringstream in(footer);
  bool is_example = false;
  bool is_exit_status = false;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) {
      is_example = is_exit_status = false;
      notes += "\n";
    } else if (begins(line, "Example")) {
      is_example = true;
    } else {
      const std::string mark = "Exit codes: ";
      const std::size_t at = is_example ? std::string::npos : line.find(mark);
      if (at != std::string::npos) {
        is_exit_status = true;
        notes += line.substr(0, at);
        line.erase(0, at + mark.size());
      }
      (is_example ? examples : is_exit_status ? exit_status : notes) += line + "\n";
    }
  }
  const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
  std::string text;
  if (!std::all_of(notes.begin(), notes.end(), is_blank)) {
    text += ".SH NOTES\n";
    std::istringstream paragraphs(notes);
    bool is_first = true;
    bool gap = false;
    for (std::string line; std::getline(paragraphs, line);) {
      if (line.empty()) {
        gap = !is_first;
        continue;
      }
      text += (gap ? ".PP\n" : "") + roff(line) + "\n";
      is_first = gap = false;
    }
  }
  if (!exit_status.empty()) text += ".SH EXIT STATUS\n" + roff(exit_status);
  if (!examples.empty()) text += ".SH EXAMPLES\n.nf\n" + roff(examples) + ".fi\n";
  return text;
}

}  // namespace

std::string man_page(const CommandPath& path, const std::string& version) {
  const CLI::App& command = *path.command;
  std::string title = path.joined("-");
  const std::string name = title;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text = ".TH \"" + roff(title) + "\" 1 \"\" \"" + roff(version) +
                     "\" \"User Commands\"\n.ad l\n.SH NAME\n" + roff(name) + " \\- " +
                     roff(command.get_description()) + "\n.SH SYNOPSIS\n" + synopsis(path);
  if (const auto arguments = positionals(command); !arguments.empty()) {
    text += ".SH ARGUMENTS\n";
    for (const CLI::Option* one : arguments) {
      text += ".TP\n" + italic(one->get_single_name()) + "\n" + roff(one->get_description()) + "\n";
    }
  }
  std::string see_also;
  std::string subcommands;
  for (const CommandPath& one : all_commands(command)) {
    if (one.words.size() != 2) continue;
    subcommands +=
        ".TP\n" + bold(one.words[1]) + "\n" + roff(one.command->get_description()) + "\n";
    see_also += (see_also.empty() ? "" : ",\n") + bold(name + "-" + one.words[1]) + "(1)";
  }
  if (!subcommands.empty()) text += ".SH COMMANDS\n" + subcommands;
  text += ".SH OPTIONS\n";
  for (const std::string& group : command.get_groups()) {
    const auto options = command.get_options([&group](const CLI::Option* one) {
      return one->nonpositional() && one->get_group() == group;
    });
    if (options.empty()) continue;
    if (group != "Options") text += ".SS " + roff(group) + "\n";
    for (const CLI::Option* one : options) text += option_entry(*one);
  }
  text += footer_sections(command.get_footer());
  if (see_also.empty()) {
    const std::size_t end = name.rfind('-', name.find(path.words.back()));
    see_also = bold(name.substr(0, end == std::string::npos ? name.size() : end)) + "(1)";
  }
  return text + ".SH SEE ALSO\n" + see_also + "\n";
}

}  // namespace circumspect::cli
