#include <functional>
#include <optional>

#include <fmt/format.h>

#include "bench/tables.hpp"

namespace circumspect::bench {
namespace {

// What a mesh of these points is to reach.
struct Limits {
  std::string prefix;  // of the names of the meshes
  double given, only, times_is_valid;
};
const std::vector<Limits> kLimits = {
    {"random", 80, 220, 15}, {"grid", 150, 300, 9}, {"sphere", 400, 600, 7}};
constexpr double kSpeedup = 1.8;
constexpr double kBytes = 32;
constexpr double kTextToVerdict = 1.5;

struct Goal {
  std::string text;
  bool at_least;  // rather than at most
  int decimals;
  std::function<double(const Limits&)> limit;
  std::function<double(const Measured&)> value;
};

std::vector<Goal> goals() {
  const auto always = [](double limit) { return [limit](const Limits&) { return limit; }; };
  return {
      {"neighbours given: at most 80, 150, 400 ns", false, 0,
       [](const Limits& limits) { return limits.given; },
       [](const Measured& m) { return m.given; }},
      {"CGAL's `is_valid`: at least 15, 9, 7 times that", true, 1,
       [](const Limits& limits) { return limits.times_is_valid; },
       [](const Measured& m) { return m.is_valid / m.given; }},
      {"points and simplices only: at most 220, 300, 600 ns", false, 0,
       [](const Limits& limits) { return limits.only; }, [](const Measured& m) { return m.only; }},
      {"two threads at least 1.8 times faster, given", true, 2, always(kSpeedup),
       [](const Measured& m) { return m.given_speedup; }},
      {"two threads at least 1.8 times faster, only", true, 2, always(kSpeedup),
       [](const Measured& m) { return m.only_speedup; }},
      {"at most 32 bytes beside the arrays", false, 1, always(kBytes),
       [](const Measured& m) { return m.bytes; }},
      {"text to verdict in at most 1.5 s", false, 2, always(kTextToVerdict),
       [](const Measured& m) { return m.text_to_verdict; }},
  };
}

std::optional<Limits> limits_of(const std::string& name) {
  for (const Limits& limits : kLimits) {
    if (name.rfind(limits.prefix, 0) == 0) return limits;
  }
  return std::nullopt;
}

std::string compared(const Goal& goal, const Limits& limits, const Measured& mesh) {
  const double value = goal.value(mesh), limit = goal.limit(limits);
  if (value == 0) return "";
  const std::string number = fmt::format("{:.{}f}", value, goal.decimals);
  if (goal.at_least ? value >= limit : value <= limit) return number + ", met";
  const double missed = goal.at_least ? 1 - value / limit : value / limit - 1;
  return fmt::format("{}, missed by {:.0f} %", number, 100 * missed);
}

}  // namespace

void print_goals(const std::vector<Measured>& meshes) {
  std::vector<Measured> columns;
  fmt::print("\n| goal, a tetrahedron of random, grid, sphere |");
  for (const Measured& mesh : meshes) {
    if (!limits_of(mesh.name)) continue;
    columns.push_back(mesh);
    fmt::print(" {} |", mesh.name);
  }
  fmt::print("\n| --- |");
  for (std::size_t i = 0; i < columns.size(); ++i) fmt::print(" --- |");
  fmt::print("\n");
  for (const Goal& goal : goals()) {
    fmt::print("| {} |", goal.text);
    for (const Measured& mesh : columns) {
      fmt::print(" {} |", compared(goal, *limits_of(mesh.name), mesh));
    }
    fmt::print("\n");
  }
}

}  // namespace circumspect::bench
