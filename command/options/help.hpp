// The layout of --help, in groups and in lines that fit the terminal, and the messages about wrong options.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace circumspect::cli {

// Has each option of a command and of all its subcommands take one word, also where it may be given several times:
// otherwise it would take those behind it as well, and a `--` with them, behind which a program has options of its own.
// Called when all options are there.
void let_options_take_one_word(CLI::App& app);

// Puts the options of a command and of all its subcommands into groups, such as "Domain", by their names, and has
// --help break its lines where the terminal ends, or after COLUMNS characters, if that is set; elsewhere, as in a
// pipe, they stay whole. Called when all options are there. Requires: `app` outlives every --help.
void lay_out_help(CLI::App& app);

// ---- Unknown words ----
// What to say of a word on the command line that means nothing there.

// A sentence about the first word that the command line had no place for: what was expected there, and the
// nearest word that means something; or, if all words had one, about the subcommand that is missing; "" if none
// is. Requires: `app` has just thrown
// CLI::RequiredError or CLI::ExtrasError, which say only that something is missing, or too much.
std::string unknown_word_text(const CLI::App& app);

}  // namespace circumspect::cli
