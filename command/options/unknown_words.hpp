// What to say of a word on the command line that means nothing there.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace circumspect::cli {

// A sentence about the first word that the command line had no place for: what was expected there, and the
// nearest word that means something; or, if all words had one, about the subcommand that is missing; "" if none
// is. Requires: `app` has just thrown
// CLI::RequiredError or CLI::ExtrasError, which say only that something is missing, or too much.
std::string unknown_word_text(const CLI::App& app);

}  // namespace circumspect::cli
