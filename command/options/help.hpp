// The layout of --help, in groups and in lines that fit the terminal.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace circumspect::cli {

// Puts the options of a command and of all its subcommands into groups, such as "Domain", by their
// names, and has --help break its lines after COLUMNS characters, if that is set, or where the
// terminal ends, or, where there is none, as in a pipe, after 80. Called when all options are
// there. Requires: `app` outlives every --help.
void lay_out_help(CLI::App& app);

// The subcommands right below, without those that are for the build and not for people.
std::vector<const CLI::App*> shown_subcommands(const CLI::App& command);

// What stands for the value of an option, such as FILE, or [ANGLE] if it may be left out; empty if
// it takes none.
std::string value_name(const CLI::Option& option);

}  // namespace circumspect::cli
