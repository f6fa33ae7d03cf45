// What the shells offer when a user presses the tab key.
#include <algorithm>

#include <CLI/CLI.hpp>

#include "command/options/help.hpp"
#include "command/pages/command_pages.hpp"

namespace circumspect::cli {
namespace {

// All names of all options, with their hyphens.
std::vector<std::string> flags_of(const CLI::Option& option) {
  std::vector<std::string> flags;
  for (const std::string& name : option.get_snames()) flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) flags.push_back("--" + name);
  return flags;
}

std::string spaced(const std::vector<std::string>& words, const std::string& by = " ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : by) + word;
  return text;
}

// The names of the subcommands right below, of those in the list.
std::vector<std::string> below(const CommandPath& path, const std::vector<CommandPath>& all) {
  std::vector<std::string> names;
  for (const CommandPath& one : all) {
    if (one.words.size() == path.words.size() + 1 &&
        std::equal(path.words.begin(), path.words.end(), one.words.begin())) {
      names.push_back(one.words.back());
    }
  }
  return names;
}

// Is the value of the option a file or a folder?
bool takes_a_file(const CLI::Option& option) {
  const std::string name = value_name(option);
  return name == "FILE" || name == "FOLDER" || name == "PREFIX" || name.compare(0, 3, "OUT") == 0;
}

// Is the word behind it the option's, whatever that is?
bool takes_a_word(const CLI::Option& option) {
  return option.get_items_expected_max() > 0 && !value_name(option).empty();
}

// The beginning of a description, as _arguments takes it between brackets and quotes.
std::string zsh_text(const std::string& description) {
  std::string text;
  for (const char c :
       description.substr(0, std::min({description.find(" ("), description.find(": "),
                                       description.find("; "), description.find(". ")}))) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      if (c == '[' || c == ']' || c == ':' || c == '\\') text += '\\';
      text += c;
    }
  }
  return text;
}

// One line of _arguments for each name of the option.
std::string zsh_option(const CLI::Option& option) {
  std::string value;
  if (takes_a_word(option)) {
    const std::vector<std::string> words = words_of(option);
    value = !words.empty()         ? ":value:(" + spaced(words) + ")"
            : takes_a_file(option) ? ":" + value_name(option) + ":_files"
                                   : ":" + zsh_text(value_name(option)) + ": ";
  }
  std::string lines;
  for (const std::string& flag : flags_of(option)) {
    lines += " \\\n    '" + std::string(option.get_items_expected_max() > 1 ? "*" : "") + flag +
             "[" + zsh_text(option.get_description()) + "]" + value + "'";
  }
  return lines;
}

// What stands without a name: files, but for the program that campaigns run, for families and for
// what `help` is about.
std::string zsh_positionals(const CLI::App& command, const std::vector<CommandPath>& all) {
  std::string lines;
  int place = 0;
  for (const CLI::Option* one :
       command.get_options([](const CLI::Option* option) { return option->get_positional(); })) {
    const std::string name = one->get_single_name();
    ++place;
    lines += " \\\n    '";
    if (name == "command") {
      // What follows "--" is completed as the command line of the other program.
      lines += "*::command:{ [[ $words[1] == -- ]] && shift words && ((CURRENT--)); _normal }";
    } else {
      lines += (one->get_items_expected_max() > 1 ? "*" : std::to_string(place)) + ":" + name +
               ":" +
               (name == "family"       ? " "
                : name == "subcommand" ? "(" + spaced(below(all.front(), all)) + ")"
                                       : "_files");
    }
    lines += "'";
  }
  return lines;
}

std::string zsh_function(const CommandPath& path, const std::vector<CommandPath>& all) {
  std::string text = "_" + path.joined("_") + "() {\n";
  const std::vector<std::string> names = below(path, all);
  std::string options;
  for (const CLI::Option* one : path.command->get_options()) {
    if (one->nonpositional()) options += zsh_option(*one);
  }
  if (names.empty()) {
    return text + "  _arguments -S" + options + zsh_positionals(*path.command, all) + "\n}\n\n";
  }
  std::string described;
  std::string calls;
  for (const CommandPath& one : all) {
    if (one.words.size() == path.words.size() + 1 &&
        std::find(names.begin(), names.end(), one.words.back()) != names.end()) {
      described +=
          "\n        '" + one.words.back() + ":" + zsh_text(one.command->get_description()) + "'";
      calls += "\n        " + one.words.back() + ") _" + one.joined("_") + " ;;";
    }
  }
  return text + "  local context state state_descr line\n  typeset -A opt_args\n  _arguments -C" +
         options +
         " \\\n    '1: :->command' \\\n    '*:: :->arguments' && return\n"
         "  case $state in\n    command)\n      local -a commands=(" +
         described +
         ")\n      _describe command commands ;;\n    arguments)\n      case $words[1] in" + calls +
         "\n      esac ;;\n  esac\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string text = "#compdef circumspect\n# Made by circumspect command-pages.\n\n";
  const std::vector<CommandPath> all = all_commands(app);
  for (const CommandPath& path : all) text += zsh_function(path, all);
  return text + "_circumspect \"$@\"\n";
}

std::string bash_completion(const CLI::App& app) {
  const std::vector<CommandPath> all = all_commands(app);
  std::string paths;
  std::string values;
  std::string options;
  for (const CommandPath& path : all) {
    const std::string name = path.joined(" ");
    if (path.words.size() > 1) paths += (paths.empty() ? "\"" : " | \"") + name + "\"";
    std::vector<std::string> flags;
    for (const CLI::Option* one : path.command->get_options()) {
      if (!one->nonpositional()) continue;
      for (const std::string& flag : flags_of(*one)) {
        flags.push_back(flag);
        if (!takes_a_word(*one)) continue;
        const std::vector<std::string> words = words_of(*one);
        values +=
            "    \"" + name + " " + flag + "\")" +
            (words.empty() ? ""
                           : " COMPREPLY=($(compgen -W \"" + spaced(words) + "\" -- \"$cur\"));") +
            " return ;;\n";
      }
    }
    const bool is_help = path.words.back() == "help";  // which takes the words that call another
    options += "    \"" + name + "\") subcommands=\"" +
               spaced(below(is_help ? all.front() : path, all)) + "\"\n      flags=\"" +
               spaced(flags) + "\" ;;\n";
  }
  return "# Made by circumspect command-pages.\n"
         "_circumspect() {\n"
         "  local cur=${COMP_WORDS[COMP_CWORD]} command=circumspect subcommands flags i\n"
         "  COMPREPLY=()\n"
         "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
         "    if [[ ${COMP_WORDS[i]} == -- ]]; then\n"
         "      ! declare -F _command_offset >/dev/null || _command_offset $((i + 1))\n"
         "      return\n"
         "    fi\n"
         "    case \"$command ${COMP_WORDS[i]}\" in\n      " +
         paths +
         ") command+=\" ${COMP_WORDS[i]}\" ;;\n"
         "    esac\n"
         "  done\n"
         "  case \"$command ${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
         values +
         "  esac\n"
         "  case \"$command\" in\n" +
         options +
         "  esac\n"
         "  if [[ $cur == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$flags\" -- \"$cur\"))\n"
         "  elif [[ -n $subcommands ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$subcommands\" -- \"$cur\"))\n"
         "  fi\n"
         "}\n"
         "complete -o default -F _circumspect circumspect\n";
}

}  // namespace circumspect::cli
