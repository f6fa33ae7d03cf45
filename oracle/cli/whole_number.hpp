// Options whose values are counts or seeds.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>

namespace circumspect::cli {

// Refuses what is not a whole number from `least` to 2^64 − 1: CLI11 would take −1 for 2^64 − 1, and
// that for any larger one.
inline CLI::Validator whole_number(std::uint64_t least = 0) {
  const auto fault = [least](std::string& text) -> std::string {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end && number >= least) return "";
    return "expected a whole number from " + std::to_string(least) + " to 2^64 - 1, found " + text;
  };
  return CLI::Validator(fault, "");
}

}  // namespace circumspect::cli
