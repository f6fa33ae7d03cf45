// Man pages and completions, made from the options of the command itself, so that they agree with
// `--help`.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace circumspect::cli {

// A command with the words that call it, such as "circumspect", "build", "delaunay".
struct CommandPath {
  std::vector<std::string> words;
  const CLI::App* command = nullptr;

  std::string joined(const std::string& by) const;
};

// The command itself and all its subcommands, however deep, hidden ones left out.
std::vector<CommandPath> all_commands(const CLI::App& app);

// The words that an option takes; empty if it takes something else, or nothing.
std::vector<std::string> words_of(const CLI::Option& option);

// The page in the language of man, as `man 7 man` describes it. `version` stands in the footer.
std::string man_page(const CommandPath& path, const std::string& version);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

}  // namespace circumspect::cli
