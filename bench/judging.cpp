#include <cstdint>
#include <vector>

#include <circumspect/judgement.hpp>
#include <fmt/format.h>

#include "bench/tables.hpp"
#include "fuzz/harness/cases.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/points_case.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::bench {
namespace {

constexpr std::uint64_t kCases = 4000;
constexpr std::uint64_t kSeed = 20260101;

struct Row {
  std::size_t dimension;
  std::size_t max_points;
  double least_cases_a_second;  // 0: any
};

SimplexArray right_answer(const generators::PointsCase& set) {
  SimplexArray simplices;
  const Triangulation triangulation = delaunay::bowyer_watson(PointSet(set.points));
  for (const Simplex& simplex : triangulation.simplices()) {
    simplices.emplace_back(simplex.begin(), simplex.end());
  }
  return simplices;
}

// Returns whether it is fast enough. The answers are made beforehand: a program's own time is not that
// of the harness.
bool time_one(const Row& row) {
  const auto families = harness::chosen_families({}, row.dimension, false);
  const auto drawn = [&](std::uint64_t index) {
    return generators::in_doubles(generators::drawn(*families[index % families.size()],
                                                    row.dimension, {row.max_points, true},
                                                    harness::mixed_seed(kSeed, index)));
  };
  std::vector<SimplexArray> answers;
  std::size_t points = 0;
  for (std::uint64_t index = 0; index < kCases; ++index) {
    const generators::PointsCase set = drawn(index);
    points += set.points.size();
    answers.push_back(right_answer(set));
  }
  std::size_t right = 0;
  const double drawing = seconds([&] {
    for (std::uint64_t index = 0; index < kCases; ++index) drawn(index);
  });
  const double both = seconds([&] {
    for (std::uint64_t index = 0; index < kCases; ++index) {
      const PointArray array = generators::array(drawn(index), row.dimension);
      right += judge("delaunay", array, answers[index]).holds ? 1 : 0;
    }
  });
  const double rate = static_cast<double>(kCases) / both;
  fmt::print(
      "| draw and judge, in process | {} | {}, {:.1f} of them distinct | {:.0f} | {:.0f} % | {} "
      "|\n",
      row.dimension, row.max_points, static_cast<double>(points) / kCases, rate,
      100 * drawing / both,
      row.least_cases_a_second > 0 ? fmt::format("{}", row.least_cases_a_second) : "");
  if (right != kCases) fmt::print("{} of {} answers were judged wrong\n", kCases - right, kCases);
  return right == kCases && rate >= row.least_cases_a_second;
}

}  // namespace

int time_judging(const std::string& wanted) {
  const std::string name = "draw and judge";
  if (name.find(wanted) == std::string::npos) return 0;
  fmt::print("\n| task | dimension | points | cases a second | of it drawing | required |\n");
  fmt::print("| --- | ---: | ---: | ---: | ---: | ---: |\n");
  int too_slow = 0;
  for (const Row& row : {Row{2, 12, 1000}, Row{3, 12, 1000}, Row{3, 24, 0}}) {
    if (!time_one(row)) ++too_slow;
  }
  return too_slow;
}

}  // namespace circumspect::bench
