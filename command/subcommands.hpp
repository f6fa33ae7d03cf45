// The subcommands. Each adds itself to the command line and runs when it is chosen.
#pragma once

#include "command/output/output.hpp"

namespace CLI {
class App;
}

namespace circumspect::cli {

void add_check(CLI::App& app, ExitCode& exit_code);
void add_certify(CLI::App& app, ExitCode& exit_code);
void add_build(CLI::App& app, ExitCode& exit_code);
void add_inspect(CLI::App& app, ExitCode& exit_code);
void add_replay(CLI::App& app, ExitCode& exit_code);
void add_campaign(CLI::App& app, ExitCode& exit_code);
void add_adapter(CLI::App& app, ExitCode& exit_code);
void add_minimize(CLI::App& app, ExitCode& exit_code);
void add_generate(CLI::App& app, ExitCode& exit_code);
void add_compare(CLI::App& app, ExitCode& exit_code);
void add_rule(CLI::App& app, ExitCode& exit_code);
void add_help(CLI::App& app, ExitCode& exit_code);
void add_command_pages(CLI::App& app, ExitCode& exit_code);

// Subcommands of build.
void add_build_subdivision(CLI::App& build, ExitCode& exit_code);
void add_build_voronoi(CLI::App& build, ExitCode& exit_code);
void add_build_all_triangulations(CLI::App& build, ExitCode& exit_code);
void add_build_constrained(CLI::App& build, ExitCode& exit_code);

}  // namespace circumspect::cli
