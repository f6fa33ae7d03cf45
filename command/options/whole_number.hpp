// Options whose values are counts, seeds, or numbers with a unit.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace circumspect::cli {

// Refuses what is not a whole number from `least` to `most`, in words for people: CLI11 would take −1 for
// 2^64 − 1, and that for any larger one, and would say "Value -1 not in range [1 - 256]".
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

// The number at the beginning of a text, and the unit behind it.
inline bool number_and_unit(const std::string& text, double& number, std::string& unit) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number) || number < 0) return false;
  unit.assign(end, text.data() + text.size());
  return true;
}

// Text such as "90", "1.5m" or "500ms" as seconds. Returns what is wrong with it, or an empty string.
inline std::string read_duration(const std::string& text, double& seconds) {
  const std::map<std::string, double> units = {{"", 1},   {"s", 1},    {"ms", 0.001},
                                               {"m", 60}, {"min", 60}, {"h", 3600}};
  std::string unit;
  double number = 0;
  if (!number_and_unit(text, number, unit) || units.count(unit) == 0 || number <= 0) {
    return fmt::format("expected a time such as 500ms, 90s, 15m or 1h, found {}", text);
  }
  seconds = number * units.at(unit);
  return "";
}

}  // namespace circumspect::cli
