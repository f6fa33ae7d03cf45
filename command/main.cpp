// circumspect: the exact oracle for Delaunay triangulations.
#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/domain_options.hpp"
#include "command/options/unknown_words.hpp"
#include "command/output/exit_code.hpp"
#include "command/output/unfinished_file.hpp"
#include "command/subcommands.hpp"
#include "oracle/model/printable.hpp"
#include "reference/existence/solver.hpp"
#include "reference/kernel/exact/number_text.hpp"

namespace {

using circumspect::cli::ExitCode;

std::string version() {
  return fmt::format("circumspect {} ({}, {}, {{fmt}} {}.{}.{}, CLI11 {})", CIRCUMSPECT_VERSION,
                     circumspect::number_libraries(), circumspect::existence::solver_version(),
                     FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                     CLI11_VERSION);
}

// Something is missing, or too much: most often since a word was mistyped.
ExitCode usage_fault(const CLI::App& app, const CLI::ParseError& error) {
  const std::string text = circumspect::cli::unknown_word_text(app);
  fmt::print(stderr, "{}\nRun with --help for more information.\n",
             circumspect::on_one_line(text.empty() ? error.what() : text));
  return ExitCode::kUsage;
}

ExitCode run(int argc, char** argv) {
  CLI::App app{
      "The exact oracle for Delaunay triangulations: judges any mesh, exactly, with a witness."};
  app.name("circumspect");
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  app.footer(
      "Example:\n"
      "  circumspect check part.1.ele                      # is it Delaunay?\n"
      "  circumspect check part.1.ele --domain part.poly   # does it fill the domain, as a CDT?\n"
      "  circumspect inspect part.poly                     # is the domain valid? does it have a "
      "CDT?\n"
      "  circumspect check --help                          # claims, formats, options\n\n"
      "Exit codes: 0 it holds, 1 it does not, 2 usage, 3 the input is at fault, 4 undecided\n"
      "within a limit, 5 internal error. Of several answers the worst counts: 5, 2, 3, 1, 4, 0.");
  app.failure_message(CLI::FailureMessage::simple);
  ExitCode exit_code = ExitCode::kHolds;
  circumspect::cli::add_check(app, exit_code);
  circumspect::cli::add_certify(app, exit_code);
  circumspect::cli::add_build(app, exit_code);
  circumspect::cli::add_inspect(app, exit_code);
  circumspect::cli::add_replay(app, exit_code);
  circumspect::cli::add_campaign(app, exit_code);
  circumspect::cli::add_minimize(app, exit_code);
  circumspect::cli::add_generate(app, exit_code);
  circumspect::cli::add_compare(app, exit_code);
  circumspect::cli::add_command_pages(app, exit_code);
  try {
    std::vector<std::string> words = circumspect::cli::with_angles_joined(argc, argv);
    std::reverse(words.begin(), words.end());
    app.parse(std::move(words));
  } catch (const CLI::RequiredError& error) {
    return usage_fault(app, error);
  } catch (const CLI::ExtrasError& error) {
    return usage_fault(app, error);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      app.exit(error);
      return ExitCode::kHolds;
    }
    // The words of the user's that a message repeats may hold anything.
    app.exit(CLI::ParseError(circumspect::on_one_line(error.what()), error.get_exit_code()));
    return ExitCode::kUsage;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  circumspect::cli::let_writing_fail_at_file_limits();
  try {
    return static_cast<int>(run(argc, argv));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "circumspect: out of memory\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "circumspect: internal error, please report it: {}\n",
               circumspect::on_one_line(error.what()));
  }
  return static_cast<int>(ExitCode::kInternalError);
}
