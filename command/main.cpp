// circumspect: the exact oracle for Delaunay triangulations.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <zlib.h>

#include "command/options/domain_options.hpp"
#include "command/options/help.hpp"
#include "command/options/words.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "kernel/exact/number.hpp"
#include "oracle/formats/bytes/zstd.hpp"
#include "oracle/formats/lzma.hpp"
#include "oracle/model/printable.hpp"
#include "platform/files.hpp"
#include "platform/new_file.hpp"
#include "platform/terminal.hpp"
#include "reference/existence/solver.hpp"

namespace circumspect::cli {
// command/CMakeLists.txt writes both: a commit or "unknown", and libraries.
const char* built_from();
const char* built_with();

// Does what the words say, on the standard files of the process, and returns the exit code. The
// Python module has the command in it, too, and calls this: once, and where there are no other
// threads, since it may fork and sets how the process ends.
int command_line(int argc, char** argv);
}  // namespace circumspect::cli

namespace {

using circumspect::cli::ExitCode;

// ", zstd 1.5.4" and the like, of those that this program was built with.
std::string optional_libraries() {
  std::string text;
  for (const auto& [name, version] : {std::pair{"zstd", circumspect::formats::version_of_zstd()},
                                      {"liblzma", circumspect::formats::version_of_lzma()}}) {
    if (!version.empty()) text += fmt::format(", {} {}", name, version);
  }
  return text;
}

std::string version() {
  return fmt::format(
      "circumspect {} ({}, {}, {}, {{fmt}} {}.{}.{}, CLI11 {}, nlohmann/json {}.{}.{}, pugixml "
      "{}.{}, "
      "zlib {}{}), commit {}",
      CIRCUMSPECT_VERSION, circumspect::number_libraries(), circumspect::cli::built_with(),
      circumspect::existence::solver_version(), FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
      FMT_VERSION % 100, CLI11_VERSION, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
      NLOHMANN_JSON_VERSION_PATCH, PUGIXML_VERSION / 1000, PUGIXML_VERSION / 10 % 100,
      zlibVersion(), optional_libraries(), circumspect::cli::built_from());
}

struct Subcommand {
  std::string_view name;
  void (*add)(CLI::App& app, ExitCode& exit_code);
};

// In the order in which --help lists them.
constexpr auto kSubcommands = std::to_array<Subcommand>({
    {"check", circumspect::cli::add_check},
    {"certify", circumspect::cli::add_certify},
    {"build", circumspect::cli::add_build},
    {"inspect", circumspect::cli::add_inspect},
    {"replay", circumspect::cli::add_replay},
#ifndef __EMSCRIPTEN__  // a browser starts no programs, and needs no inputs for them
    {"campaign", circumspect::cli::add_campaign},
    {"adapter", circumspect::cli::add_adapter},
    {"minimize", circumspect::cli::add_minimize},
    {"generate", circumspect::cli::add_generate},
#endif
    {"compare", circumspect::cli::add_compare},
    {"rule", circumspect::cli::add_rule},
    {"help", circumspect::cli::add_help},
#ifndef __EMSCRIPTEN__
    {"command-pages", circumspect::cli::add_command_pages},
#endif
});

// The one that the first word names: the options of all take longer to make than a small mesh to
// judge. All of them if it names none, as --help lists them, and for help and command-pages, which
// describe them.
std::span<const Subcommand> called(int argc, char** argv) {
  const std::string_view word = argc > 1 ? argv[1] : "";
  const auto found = std::find_if(kSubcommands.begin(), kSubcommands.end(),
                                  [&](const Subcommand& one) { return one.name == word; });
  if (found == kSubcommands.end() || word == "help" || word == "command-pages") return kSubcommands;
  return {found, 1};
}

ExitCode say_usage(const std::string& text) {
  circumspect::cli::say(circumspect::on_one_line(text) +
                        "\nRun with --help for more information.\n");
  return ExitCode::kUsage;
}

// Something is missing, or too much: most often since a word was mistyped. It may be a word of
// another subcommand.
ExitCode usage_fault(CLI::App& app, const CLI::ParseError& error, ExitCode& exit_code) {
  for (const Subcommand& subcommand : kSubcommands) {
    const auto is_it = [&](const CLI::App* one) { return one->get_name() == subcommand.name; };
    if (app.get_subcommands(is_it).empty()) subcommand.add(app, exit_code);
  }
  const std::string text = circumspect::cli::unknown_word_text(app);
  return say_usage(text.empty() ? error.what() : text);
}

ExitCode run(int argc, char** argv) {
  CLI::App app{
      "The exact oracle for Delaunay triangulations: judges any mesh, exactly, with a witness."};
  app.name("circumspect");
  app.allow_windows_style_options(false);  // there, too, `/mesh.off` is a file
  app.set_version_flag("-V,--version", version());
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
  for (const Subcommand& subcommand : called(argc, argv)) subcommand.add(app, exit_code);
  circumspect::cli::deal_words_to_options(app);
  circumspect::cli::lay_out_help(app);
  try {
    std::vector<std::string> words = circumspect::cli::with_angles_joined(argc, argv);
    std::reverse(words.begin(), words.end());
    app.parse(std::move(words));
  } catch (const CLI::RequiredError& error) {
    return usage_fault(app, error, exit_code);
  } catch (const CLI::ExtrasError& error) {
    return usage_fault(app, error, exit_code);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string text = circumspect::cli::value_text(app, error.what());
    return say_usage(text.empty() ? error.what() : text);
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

// Called where memory is exhausted: asks for none.
[[noreturn]] void end_without_memory() {
  constexpr std::string_view kText = "circumspect: out of memory\n";
  circumspect::platform::write_some(circumspect::platform::kStandardError, kText.data(),
                                    kText.size());
  circumspect::platform::remove_unfinished_files();
  std::_Exit(static_cast<int>(ExitCode::kInternalError));
}

std::terminate_handler usual_end = nullptr;

// Destructors must not throw, and some of nlohmann::json ask for memory: where it is exhausted,
// they come here.
[[noreturn]] void end_where_nobody_catches() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {
    usual_end();
  }
  usual_end();
  std::abort();
}

}  // namespace

int circumspect::cli::command_line(int argc, char** argv) {
  circumspect::platform::prepare_standard_files();
  circumspect::platform::let_writing_fail_at_file_limits();
  circumspect::end_where_numbers_exhaust_memory(end_without_memory);
  usual_end = std::set_terminate(end_where_nobody_catches);
  try {
    return static_cast<int>(circumspect::cli::when_written(::run(argc, argv)));
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::system_error& error) {  // the system would not: that is not a mistake of ours
    circumspect::cli::say("circumspect: " + circumspect::on_one_line(error.what()) + "\n");
  } catch (const std::exception& error) {
    circumspect::cli::say("circumspect: internal error, please report it: " +
                          circumspect::on_one_line(error.what()) + "\n");
  }
  return static_cast<int>(ExitCode::kInternalError);
}

int main(int argc, char** argv) {
  argv = circumspect::platform::arguments(argc, argv);
  return circumspect::cli::command_line(argc, argv);
}
