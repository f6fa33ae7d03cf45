// Options whose values are times or sizes: a number with a unit.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/option_rows.hpp"

namespace circumspect::cli {

// The number at the beginning of a text, and the unit behind it.
inline bool number_and_unit(const std::string& text, double& number, std::string& unit) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number) || number < 0) return false;
  unit.assign(end, text.data() + text.size());
  return true;
}

// Text such as "90", "1.5m" or "500ms" as seconds. Returns what is wrong with it, or an empty
// string.
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

// Text such as "2G", "512M", "64k" or "0" as bytes. Returns what is wrong with it, or an empty
// string.
inline std::string read_bytes(const std::string& text, std::uint64_t& bytes) {
  const std::map<std::string, int> units = {{"", 0},   {"k", 10}, {"K", 10},
                                            {"M", 20}, {"G", 30}, {"T", 40}};
  std::string unit;
  double number = 0;
  if (!number_and_unit(text, number, unit) || units.count(unit) == 0 || number > 1e6) {
    return fmt::format("expected a size such as 64k, 512M or 2G, found {}", text);
  }
  bytes = static_cast<std::uint64_t>(std::ldexp(number, units.at(unit)));
  return "";
}

inline Place duration(std::optional<double>& seconds) {
  return read_by([&seconds](const std::string& text) {
    double read = 0;
    const std::string fault = read_duration(text, read);
    if (fault.empty()) seconds = read;
    return fault;
  });
}

inline Place size_in_bytes(std::uint64_t& bytes) {
  return read_by([&bytes](const std::string& text) { return read_bytes(text, bytes); });
}

}  // namespace circumspect::cli
