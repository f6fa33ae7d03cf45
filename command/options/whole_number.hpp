// Options whose values are counts, seeds, or numbers with a unit.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <thread>

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

// ---- Threads ----
// How many threads judge a mesh.

// Adds --threads; 0 if it is not given.
inline void add_threads_option(CLI::App& command, std::uint64_t& threads) {
  command
      .add_option("--threads", threads,
                  "Read and judge with at most N threads (default: one for each processor). The "
                  "answer is the same for any number")
      ->check(whole_number(1))
      ->option_text("N");
}

// As many as were asked for, but no more than there are processors: they would wait for each other.
inline unsigned thread_count(std::uint64_t asked) {
  const std::uint64_t most = std::max(1U, std::thread::hardware_concurrency());
  return static_cast<unsigned>(asked == 0 ? most : std::min(asked, most));
}

}  // namespace circumspect::cli
