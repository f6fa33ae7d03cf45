// Which words of a command line belong to which option, and what to say of a word that means
// nothing there.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace circumspect::cli {

// Has each option of a command and of all its subcommands take one word, also where it may be given
// several times: otherwise it would take those behind it as well, and a `--` with them, behind
// which a program has options of its own. Flags take none: CLI11 would read --oriented=no and
// --quiet=3 as something. The name of another option of the command is not a value. Called when all
// options are there.
void deal_words_to_options(CLI::App& app);

// "circumspect build cdt"
std::string whole_name(const CLI::App& command);

// The command that these words call, such as "build" and "cdt". If there is none: nullptr, and
// `fault` says which word is none, and which are.
const CLI::App* named_command(const CLI::App& app, const std::vector<std::string>& words,
                              std::string& fault);

// A sentence about the first word that the command line had no place for: what was expected there,
// and the nearest word that means something; or, if all words had one, about the subcommand that is
// missing; "" if none is. Requires: `app` has just thrown CLI::RequiredError or CLI::ExtrasError,
// which say only that something is missing, or too much.
std::string unknown_word_text(const CLI::App& app);

// A sentence about the option that lacks its value, or is a flag and has one; "" if the message
// names no option. Requires: `app` has just thrown CLI::ArgumentMismatch with this message, which
// begins with the option's name.
std::string value_text(const CLI::App& app, const std::string& message);

}  // namespace circumspect::cli
