// circumspect help [SUBCOMMAND…]: the same as --help behind these words.
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command/options/words.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::cli {

void add_help(CLI::App& app, ExitCode& exit_code) {
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("help", "Print what --help prints of a subcommand");
  command->footer(
      "Example:\n"
      "  circumspect help check\n"
      "  circumspect help build cdt\n"
      "\n"
      "Exit codes: 0 printed, 2 usage, 5 internal error.");
  command->add_option("subcommand", *words, "The words that call it, such as build cdt");
  command->callback([&app, words, &exit_code] {
    std::string fault;
    const CLI::App* const named = named_command(app, *words, fault);
    if (named == nullptr) {
      say(on_one_line(fault) + "\nRun with --help for more information.\n");
      exit_code = ExitCode::kUsage;
      return;
    }
    Output output{OutputOptions{}};
    output.text(
        named->get_formatter()->make_help(named, whole_name(*named), CLI::AppFormatMode::Normal));
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
