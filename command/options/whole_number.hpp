// Options whose values are counts or seeds.
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>

namespace circumspect::cli {

// Refuses what is not a whole number from `least` to `most`, in words for people: CLI11 would take
// −1 for 2^64 − 1, and that for any larger one, and would say "Value -1 not in range [1 - 256]".
inline CLI::Validator whole_number(std::uint64_t least = 0,
                                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  const auto fault = [least, most](std::string& text) -> std::string {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    const bool is_whole = read.ec == std::errc() && read.ptr == end;
    if (is_whole && least <= number && number <= most) return "";
    const bool is_any = most == std::numeric_limits<std::uint64_t>::max();
    return "expected a whole number from " + std::to_string(least) + " to " +
           (is_any ? "2^64 - 1" : std::to_string(most)) + ", found " + text;
  };
  return CLI::Validator(fault, "");
}

}  // namespace circumspect::cli
