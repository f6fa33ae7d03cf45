#include "bench/checking.hpp"

#define CGAL_NDEBUG  // as its users build it

#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <circumspect/check.hpp>
#include <fmt/format.h>

#include "bench/processor_time.hpp"

namespace circumspect::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::int32_t, Kernel>;
using Cell =
    CGAL::Triangulation_cell_base_with_info_3<std::int32_t, Kernel,
                                              CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
using Cgal = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
using Points = std::vector<std::pair<Kernel::Point_3, std::int32_t>>;

void add(Points& points, double x, double y, double z) {
  points.emplace_back(Kernel::Point_3(x, y, z), static_cast<std::int32_t>(points.size()));
}

Points random_points(int count) {
  Points points;
  std::mt19937_64 random(20260101);
  const auto coordinate = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate();
    add(points, x, y, coordinate());
  }
  return points;
}

Points grid_points(int side) {
  Points points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) add(points, x, y, z);
    }
  }
  return points;
}

Points sphere_points(int count) {
  Points points;
  for (const auto& [point, name] : random_points(2 * count)) {
    const double x = point.x() - 0.5, y = point.y() - 0.5, z = point.z() - 0.5;
    const double radius = std::sqrt(x * x + y * y + z * z);
    if (radius > 0.5 || radius == 0) continue;
    add(points, x / radius, y / radius, z / radius);
  }
  return points;
}

struct Arrays {
  std::vector<double> coordinates;
  std::vector<std::int32_t> simplices;
  std::vector<std::int32_t> neighbors;
};

Arrays arrays_of(const Points& points, Cgal& mesh) {
  Arrays arrays;
  for (const auto& [point, name] : points) {
    arrays.coordinates.insert(arrays.coordinates.end(), {point.x(), point.y(), point.z()});
  }
  for (const auto& cell : mesh.all_cell_handles()) cell->info() = -1;
  std::int32_t count = 0;
  for (const auto& cell : mesh.finite_cell_handles()) cell->info() = count++;
  for (const auto& cell : mesh.finite_cell_handles()) {
    for (int i = 0; i < 4; ++i) {
      arrays.simplices.push_back(cell->vertex(i)->info());
      arrays.neighbors.push_back(cell->neighbor(i)->info());
    }
  }
  return arrays;
}

// The least of three times, which the machine's other work disturbs least.
template <typename Work>
double least_seconds(const Work& work) {
  double least = seconds(work);
  for (int i = 0; i < 2; ++i) least = std::min(least, seconds(work));
  return least;
}

// What two threads gain, by the clock on the wall.
double speedup(const MeshArrays<std::int32_t>& mesh) {
  double best[2] = {1e9, 1e9};
  for (int i = 0; i < 6; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    judge("delaunay", mesh, {.threads = i % 2 == 0 ? 1U : 2U});
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    best[i % 2] = std::min(best[i % 2], time.count());
  }
  return best[0] / best[1];
}

// Returns whether the mesh was found right, and by the fast judge.
bool time_one(const std::string& name, const Points& points) {
  Cgal cgal;
  const double building = seconds([&] { cgal.insert(points.begin(), points.end()); });
  const Arrays arrays = arrays_of(points, cgal);
  const MeshArrays<std::int32_t> given{.coordinates = arrays.coordinates,
                                       .simplices = arrays.simplices,
                                       .neighbors = arrays.neighbors};
  const MeshArrays<std::int32_t> bare{.coordinates = arrays.coordinates,
                                      .simplices = arrays.simplices};
  const auto simplices = static_cast<double>(arrays.simplices.size() / 4);
  const auto each = [&](double time) { return time / simplices * 1e9; };
  const MeshJudgement judgement = judge("delaunay", given);
  const double with = each(least_seconds([&] { judge("delaunay", given); }));
  const double without = each(least_seconds([&] { judge("delaunay", bare); }));
  const double theirs = each(seconds([&] { cgal.is_valid(); }));
  fmt::print("| {} | {:.0f} | {:.0f} | {:.2f} | {:.0f} | {:.0f} | {:.0f} | {:.1f} | {:.0f} |\n",
             name, simplices, with, speedup(given), without, each(building), theirs, theirs / with,
             static_cast<double>(judgement.counts.exact_signs) / simplices * 1000);
  return judgement.holds && judgement.counts.fast;
}

}  // namespace

int time_checking(const std::string& wanted) {
  if (std::string("check").find(wanted) == std::string::npos) return 0;
  fmt::print("\nJudging meshes in arrays: nanoseconds a tetrahedron, one thread\n\n");
  fmt::print(
      "| points | tetrahedra | neighbours given | two threads, times faster | points and "
      "simplices only | CGAL builds it | CGAL `is_valid` | times ours | exact signs in 1000 "
      "tetrahedra |\n");
  fmt::print("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  int wrong = 0;
  wrong += time_one("random 10^5", random_points(100000)) ? 0 : 1;
  wrong += time_one("grid 46^3", grid_points(46)) ? 0 : 1;
  wrong += time_one("sphere 10^5", sphere_points(100000)) ? 0 : 1;
  return wrong;
}

}  // namespace circumspect::bench
