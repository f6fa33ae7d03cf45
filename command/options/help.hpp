// How --help is laid out: options in groups, lines that fit the terminal.
#pragma once

namespace CLI {
class App;
}

namespace circumspect::cli {

// Puts the options of a command and of all its subcommands into groups, such as "Domain", by their names, and has
// --help break its lines where the terminal ends, or after COLUMNS characters, if that is set; elsewhere, as in a
// pipe, they stay whole. Called when all options are there. Requires: `app` outlives every --help.
void lay_out_help(CLI::App& app);

}  // namespace circumspect::cli
