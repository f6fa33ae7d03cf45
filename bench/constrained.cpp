#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "bench/tables.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/flip_insert_polygon.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/steiner_cdt.hpp"

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
  double seconds_allowed;                                         // 0: any
  std::function<std::string(const PiecewiseLinearComplex&)> run;  // says what came of it
  // Make the complex edge-protected first, so that it has a CDT? The cost of that is not counted.
  bool is_protected = false;
};

std::string tetrahedra(std::size_t count) { return fmt::format("{} tetrahedra", count); }

std::string by_polygons(const PiecewiseLinearComplex& complex, constrained::PolygonInsertion by) {
  std::vector<constrained::PolygonFlips> runs;
  const auto cdt = constrained::cdt_by_polygon_insertion(complex, {.by = by}, &runs);
  if (!cdt) return "no CDT";
  std::size_t flips = 0;
  for (const auto& run : runs) flips += run.flips.size();
  return tetrahedra(cdt->simplices.size()) + fmt::format(", {} flips", flips);
}

std::string wrapped(const PiecewiseLinearComplex& complex) {
  const auto cdt = constrained::gift_wrapping_cdt(complex);
  return cdt ? tetrahedra(cdt->simplices.size()) : "no CDT";
}
std::string flipped(const PiecewiseLinearComplex& complex) {
  return by_polygons(complex, constrained::PolygonInsertion::kFlips);
}
std::string dug(const PiecewiseLinearComplex& complex) {
  return by_polygons(complex, constrained::PolygonInsertion::kCavities);
}
std::string with_steiner_points(const PiecewiseLinearComplex& complex) {
  const auto cdt = constrained::steiner_cdt(complex);
  return tetrahedra(cdt.triangulation.simplices.size()) +
         fmt::format(", {} Steiner points", cdt.steiner_points.size());
}

std::vector<Task> tasks() {
  return {{"CDT by gift-wrapping", 7, 2, 0, wrapped, true},
          {"CDT by gift-wrapping", 13, 2, 30, wrapped, true},
          {"CDT by polygons, with flips", 12, 2, 0, flipped, true},
          {"CDT by polygons, with flips", 64, 2, 60, flipped, true},
          {"CDT by polygons, with cavities", 12, 2, 0, dug, true},
          {"Steiner CDT", 14, 3, 0, with_steiner_points}};
}

// How long it takes to find that a surface is valid.
int time_validity(int side, double seconds_allowed) {
  const PiecewiseLinearInput input = landscape(side, 1);
  bool is_valid = false;
  const double now = seconds([&] { is_valid = validated(input).has_value(); });
  fmt::print("| validity of a surface | {} | {} | {} | {:.2f} | {} |\n", input.points.size(),
             input.polygons.size(), is_valid ? "valid" : "not valid", now,
             seconds_allowed > 0 ? fmt::format("{} s", seconds_allowed) : "");
  return seconds_allowed > 0 && now > seconds_allowed ? 1 : 0;
}

}  // namespace

int time_constrained(const std::string& wanted) {
  int too_slow = 0;
  fmt::print("\n| task | vertices | polygons | result | seconds | allowed |\n");
  fmt::print("| --- | ---: | ---: | --- | ---: | ---: |\n");
  if (std::string("validity of a surface").find(wanted) != std::string::npos) {
    too_slow += time_validity(71, 0) + time_validity(224, 10);
  }
  for (const Task& task : tasks()) {
    if (task.name.find(wanted) == std::string::npos) continue;
    PiecewiseLinearComplex complex = assemble(landscape(task.side, task.relief));
    if (task.is_protected) complex = constrained::recover_segments(complex).complex;
    std::string result;
    const double now = seconds([&] { result = task.run(complex); });
    const bool has_goal = task.seconds_allowed > 0;
    fmt::print("| {} | {} | {} | {} | {:.2f} | {} |\n", task.name, complex.points.size(),
               complex.polygons.size(), result, now,
               has_goal ? fmt::format("{} s", task.seconds_allowed) : "");
    std::fflush(stdout);
    if (has_goal && now > task.seconds_allowed) ++too_slow;
  }
  return too_slow;
}

}  // namespace circumspect::bench
