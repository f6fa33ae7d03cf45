// Prints the tables of docs/performance.md. With arguments, only the algorithms whose name contains
// the first one; of the table of `check` only the rows whose name contains the second:
//
//     circumspect_bench check sphere
//
// After --, the program of campaigns, and before it the name of its mesh:
//
//     circumspect_bench campaign x.1.ele -- tetgen -JQ {points}
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/point_sets.hpp"
#include "bench/tables.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::bench {
namespace {

// The exponent e for which n^e grows as the measured values do.
double growth(double smaller_n, double smaller, double larger_n, double larger) {
  return std::log(larger / smaller) / std::log(larger_n / smaller_n);
}

// Returns how many algorithms took longer than they may.
int time_all(const std::string& wanted) {
  int too_slow = 0;
  fmt::print("| algorithm | points | simplices | seconds | growth from the first | allowed |\n");
  fmt::print("| --- | ---: | ---: | ---: | ---: | ---: |\n");
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.name.find(wanted) == std::string::npos) continue;
    double first = 0;
    for (std::size_t i = 0; i < algorithm.sizes.size(); ++i) {
      const std::size_t n = algorithm.sizes[i];
      const PointSet points(random_in_cube(n, 3));
      std::size_t simplices = 0;
      const double now =
          seconds([&] { simplices = algorithm.construct(points).simplices().size(); });
      std::string exponent;
      if (i > 0) {
        exponent = fmt::format("n^{:.2f}", growth(static_cast<double>(algorithm.sizes[0]), first,
                                                  static_cast<double>(n), now));
      }
      std::string allowed;
      if (i + 1 == algorithm.sizes.size() && algorithm.seconds_allowed > 0) {
        allowed = fmt::format("{} s", algorithm.seconds_allowed);
        if (now > algorithm.seconds_allowed) ++too_slow;
      }
      fmt::print("| {} | {} | {} | {:.2f} | {} | {} |\n", algorithm.name, n, simplices, now,
                 exponent, allowed);
      std::fflush(stdout);
      if (i == 0) first = now;
    }
  }
  return too_slow;
}

// The simplices that inserting the points creates and deletes.
double changes(const std::vector<Point>& points, delaunay::InsertionOrder order) {
  delaunay::Statistics statistics;
  delaunay::bowyer_watson(PointSet(points),
                          {.order = order, .location = delaunay::PointLocation::kWalking},
                          &statistics);
  return static_cast<double>(statistics.solid_simplices_created +
                             statistics.solid_simplices_deleted);
}

// Book: Chapter 5, Exercise 1.
void count_changes_on_grids() {
  fmt::print("\n| grid | n | changes, random order | growth | changes, adversary | growth |\n");
  fmt::print("| --- | ---: | ---: | ---: | ---: | ---: |\n");
  double n_before = 0;
  double random_before = 0;
  double adversary_before = 0;
  for (const int side : {4, 6, 8, 11, 16}) {
    const double n = side * side * side;
    const double random = changes(cubic_grid(side), delaunay::InsertionOrder::kRandom);
    const double adversary =
        changes(cubic_grid_adversarial(side), delaunay::InsertionOrder::kAsGiven);
    const auto exponent = [&](double before, double now) {
      return n_before > 0 ? fmt::format("n^{:.2f}", growth(n_before, before, n, now)) : "";
    };
    fmt::print("| {0}×{0}×{0} | {1:.0f} | {2:.0f} | {3} | {4:.0f} | {5} |\n", side, n, random,
               exponent(random_before, random), adversary, exponent(adversary_before, adversary));
    std::fflush(stdout);
    n_before = n;
    random_before = random;
    adversary_before = adversary;
  }
}

}  // namespace
}  // namespace circumspect::bench

int main(int count, char** arguments) try {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  const auto dashes = std::find(words.begin(), words.end(), "--");
  const std::string wanted = dashes != words.begin() ? words.front() : "";
  circumspect::bench::Program program;
  if (dashes - words.begin() > 1) program.mesh = words[1];
  if (words.end() - dashes > 1) program.command.assign(dashes + 1, words.end());
  int too_slow = circumspect::bench::time_all(wanted);
  too_slow += circumspect::bench::time_constrained(wanted);
  too_slow += circumspect::bench::time_judging(wanted);
  too_slow += circumspect::bench::time_campaigns(wanted, program);
  circumspect::bench::time_checking(wanted, dashes - words.begin() > 1 ? words[1] : "");
  if (wanted.empty()) circumspect::bench::count_changes_on_grids();
  if (too_slow > 0) fmt::print("\n{} algorithms took longer than they may\n", too_slow);
  return too_slow == 0 ? 0 : 1;
} catch (const std::exception& fault) {
  fmt::print(stderr, "{}\n", fault.what());
  return 1;
}
