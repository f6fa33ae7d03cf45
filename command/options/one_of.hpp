// Options whose values are words.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>

#include "command/options/nearest_word.hpp"
#include "oracle/model/claim.hpp"

namespace circumspect::cli {

// For CLI::Option::transform: takes one of the words, in whatever case, for what it stands for.
// CLI11's own CLI::CheckedTransformer shows its users the numbers of the enumerators.
template <class Enum>
CLI::Validator one_of(const std::map<std::string, Enum>& words) {
  static_assert(std::is_enum_v<Enum>);
  const auto read = [words](std::string& text) -> std::string {
    std::string expected;
    std::vector<std::string> known;
    for (const auto& [word, value] : words) {
      if (CLI::detail::to_lower(text) == word) {
        text = std::to_string(static_cast<std::underlying_type_t<Enum>>(value));
        return "";
      }
      expected += (expected.empty() ? "" : "|") + word;
      known.push_back(word);
    }
    return "expected " + expected + ", found " + text + nearest_text(text, known);
  };
  return CLI::Validator(read, "");
}

// For CLI::Option::check: takes one of the words as it stands.
inline CLI::Validator one_of_words(const std::vector<std::string>& words) {
  const auto fault = [words](std::string& text) -> std::string {
    std::string expected;
    for (const std::string& word : words) {
      if (text == word) return "";
      expected += (expected.empty() ? "" : "|") + word;
    }
    return "expected " + expected + ", found " + text + nearest_text(text, words);
  };
  return CLI::Validator(fault, "");
}

// Adds --claim with all claims that there are.
inline CLI::Option* add_claim_option(CLI::App& command, std::optional<Claim>& claim,
                                     const std::string& about) {
  std::map<std::string, Claim> words;
  std::string text;
  for (const ClaimEntry& one : claims()) {
    words[std::string(one.name)] = one.claim;
    text += (text.empty() ? "" : "|") + std::string(one.name);
  }
  return command.add_option("--claim", claim, about)->transform(one_of(words))->option_text(text);
}

}  // namespace circumspect::cli
