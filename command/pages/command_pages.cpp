// circumspect command-pages FOLDER: for the build, which installs what is written. `--help` does
// not show it.
#include "command/pages/command_pages.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

#include "command/options/help.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"

namespace circumspect::cli {

std::string CommandPath::joined(const std::string& by) const {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : by) + word;
  return text;
}

std::vector<CommandPath> all_commands(const CLI::App& app) {
  std::vector<CommandPath> commands;
  const std::function<void(std::vector<std::string>, const CLI::App&)> add =
      [&](std::vector<std::string> words, const CLI::App& command) {
        words.push_back(command.get_name());
        commands.push_back({words, &command});
        for (const CLI::App* one : shown_subcommands(command)) add(words, *one);
      };
  add({}, app);
  return commands;
}

std::vector<std::string> words_of(const CLI::Option& option) {
  const std::string text = value_name(option);
  if (text.find('|') == std::string::npos) return {};
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, '|');) words.push_back(word);
  return words;
}

namespace {

// Writes each file where packages look for it below share/.
std::string write_command_pages(const CLI::App& app, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files = {
      {"bash-completion/completions/circumspect", bash_completion(app)},
      {"zsh/site-functions/_circumspect", zsh_completion(app)}};
  for (const CommandPath& path : all_commands(app)) {
    files.emplace_back("man/man1/" + path.joined("-") + ".1",
                       man_page(path, "circumspect " CIRCUMSPECT_VERSION));
  }
  for (const auto& [name, text] : files) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    std::error_code failure;
    std::filesystem::create_directories(path.parent_path(), failure);
    if (failure) return path.parent_path().string() + ": " + failure.message();
    const std::string error =
        write_file(path.string(), [&text = text](std::ostream& out) { out << text; });
    if (!error.empty()) return error;
  }
  return "";
}

}  // namespace

void add_command_pages(CLI::App& app, ExitCode& exit_code) {
  const auto folder = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("command-pages", "Write man pages and completions for bash and zsh");
  command->group("");
  command->add_option("folder", *folder, "The folder that stands for share/")->required();
  command->callback([&app, folder, &exit_code] {
    Output output({});
    const std::string error = write_command_pages(app, *folder);
    if (!error.empty()) output.error(ExitCode::kUsage, "folder", *folder, error);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
