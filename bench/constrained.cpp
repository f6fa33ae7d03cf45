#include "bench/constrained.hpp"

#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "bench/processor_time.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/steiner_cdt.hpp"
#include "reference/piecewise_linear/validity.hpp"

namespace circumspect::bench {
namespace {

// A slab with side² vertices above and four below: a landscape of triangles over a grid of unit
// squares, its heights multiples of 1/64 up to `relief`.
PiecewiseLinearInput landscape(int side, double relief) {
  std::mt19937 random(5);
  PiecewiseLinearInput input;
  const auto at = [side](int x, int y) { return static_cast<Vertex>(y * side + x); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto step = static_cast<long>(random() % static_cast<unsigned>(64 * relief + 1));
      input.points.push_back({x, y, 4 + Rational(step, 64)});
    }
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      input.polygons.push_back({{{at(x, y), at(x + 1, y), at(x + 1, y + 1)}}, {}});
      input.polygons.push_back({{{at(x, y), at(x + 1, y + 1), at(x, y + 1)}}, {}});
    }
  }
  const int last = side - 1;
  const auto base = static_cast<Vertex>(input.points.size());
  input.points.insert(input.points.end(), {{0, 0, 0}, {last, 0, 0}, {last, last, 0}, {0, last, 0}});
  std::vector<std::vector<Vertex>> rims(4);
  for (int i = 0; i < side; ++i) {
    rims[0].push_back(at(i, 0));
    rims[1].push_back(at(last, i));
    rims[2].push_back(at(last - i, last));
    rims[3].push_back(at(0, last - i));
  }
  for (Vertex i = 0; i < 4; ++i) {
    std::vector<Vertex> wall = rims[static_cast<std::size_t>(i)];
    wall.insert(wall.end(), {base + (i + 1) % 4, base + i});
    input.polygons.push_back({{wall}, {}});
  }
  input.polygons.push_back({{{base, base + 1, base + 2, base + 3}}, {}});
  return input;
}

struct Task {
  std::string name;
  int side;
  double relief;
  double seconds_allowed;                                       // 0: any
  std::function<std::string(const PiecewiseLinearInput&)> run;  // says what came of it
};

std::string tetrahedra(std::size_t count) { return fmt::format("{} tetrahedra", count); }

// Made edge-protected beforehand, so that a CDT exists: the cost of that is not counted.
std::string by_polygons(const PiecewiseLinearComplex& complex, constrained::PolygonInsertion by) {
  std::vector<constrained::PolygonFlips> runs;
  const auto cdt = constrained::cdt_by_polygon_insertion(complex, {.by = by}, &runs);
  if (!cdt) return "no CDT";
  std::size_t flips = 0;
  for (const auto& run : runs) flips += run.flips.size();
  return tetrahedra(cdt->simplices.size()) + fmt::format(", {} flips", flips);
}

std::string validity(const PiecewiseLinearInput& input) {
  return validated(input) ? "valid" : "not valid";
}
std::string wrapped(const PiecewiseLinearInput& input) {
  const auto cdt = constrained::gift_wrapping_cdt(assemble(input));
  return cdt ? tetrahedra(cdt->simplices.size()) : "no CDT";
}
std::string flipped(const PiecewiseLinearInput& input) {
  return by_polygons(assemble(input), constrained::PolygonInsertion::kFlips);
}
std::string dug(const PiecewiseLinearInput& input) {
  return by_polygons(assemble(input), constrained::PolygonInsertion::kCavities);
}
std::string with_steiner_points(const PiecewiseLinearInput& input) {
  const auto cdt = constrained::steiner_cdt(assemble(input));
  return tetrahedra(cdt.triangulation.simplices.size()) +
         fmt::format(", {} Steiner points", cdt.steiner_points.size());
}

std::vector<Task> tasks() {
  return {{"validity of a surface", 71, 1, 0, validity},
          {"validity of a surface", 224, 1, 10, validity},
          {"CDT by gift-wrapping", 7, 0.5, 0, wrapped},
          {"CDT by gift-wrapping", 14, 0.5, 30, wrapped},
          {"CDT by polygons, with flips", 14, 0.5, 0, flipped},
          {"CDT by polygons, with flips", 70, 0.5, 60, flipped},
          {"CDT by polygons, with cavities", 14, 0.5, 0, dug},
          {"Steiner CDT", 14, 3, 0, with_steiner_points}};
}

}  // namespace

int time_constrained(const std::string& wanted) {
  int too_slow = 0;
  fmt::print("\n| task | vertices | polygons | result | seconds | allowed |\n");
  fmt::print("| --- | ---: | ---: | --- | ---: | ---: |\n");
  for (const Task& task : tasks()) {
    if (task.name.find(wanted) == std::string::npos) continue;
    const PiecewiseLinearInput input = landscape(task.side, task.relief);
    std::string result;
    const double now = seconds([&] { result = task.run(input); });
    const bool has_goal = task.seconds_allowed > 0;
    fmt::print("| {} | {} | {} | {} | {:.2f} | {} |\n", task.name, input.points.size(),
               input.polygons.size(), result, now,
               has_goal ? fmt::format("{} s", task.seconds_allowed) : "");
    std::fflush(stdout);
    if (has_goal && now > task.seconds_allowed) ++too_slow;
  }
  return too_slow;
}

}  // namespace circumspect::bench
