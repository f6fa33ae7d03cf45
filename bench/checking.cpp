#include "bench/checking.hpp"

#define CGAL_NDEBUG  // as its users build it

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <circumspect/check.hpp>
#include <fmt/format.h>
#include <malloc.h>
#include <stdlib.h>

#include "bench/check_files.hpp"
#include "bench/check_points.hpp"
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

class Folder {
 public:
  Folder() {
    std::string pattern = std::filesystem::temp_directory_path() / "circumspect_bench_XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    name_ = pattern;
  }
  ~Folder() { std::filesystem::remove_all(name_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

Points points_of(const std::vector<double>& coordinates) {
  Points points;
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    points.emplace_back(Kernel::Point_3(coordinates[i], coordinates[i + 1], coordinates[i + 2]),
                        static_cast<std::int32_t>(i / 3));
  }
  return points;
}

Arrays arrays_of(const std::vector<double>& coordinates, Cgal& mesh) {
  Arrays arrays{.coordinates = coordinates, .simplices = {}, .neighbors = {}};
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

double wall_seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// A number of /proc/self/status, in bytes.
double memory(const std::string& field) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(field, 0) == 0) return 1024 * std::stod(line.substr(field.size() + 1));
  }
  return 0;
}

struct Cost {
  double seconds = 0;  // of one thread
  double speedup = 0;  // of two, by the clock on the wall
  double bytes = 0;    // beside the arrays, at most at a time
};

Cost cost_of(const std::string& claim, const MeshArrays<std::int32_t>& mesh) {
  Cost cost;
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // forgets the largest size so far
  const double before = memory("VmRSS:");
  judge(claim, mesh);
  cost.bytes = memory("VmHWM:") - before;
  cost.seconds = least_seconds([&] { judge(claim, mesh); });
  double best[2] = {1e9, 1e9};
  for (int i = 0; i < 6; ++i) {
    const unsigned threads = i % 2 == 0 ? 1 : 2;
    best[i % 2] =
        std::min(best[i % 2], wall_seconds([&] { judge(claim, mesh, {.threads = threads}); }));
  }
  cost.speedup = best[0] / best[1];
  return cost;
}

// What -C or -CC costs TetGen: it reads the files, and builds its mesh of them, with and without it.
double tetgen_seconds(const std::string& stem, const std::string& check) {
  double least[2] = {1e9, 1e9};
  for (int i = 0; i < 6; ++i) {
    const RunTime time = run({"tetgen", "-rNEFQ" + (i % 2 == 0 ? "" : check), stem + ".ele"});
    if (!time.succeeded) return 0;
    least[i % 2] = std::min(least[i % 2], time.processor);
  }
  return least[1] - least[0];
}

// Empty if there is nothing to compare with.
std::string in_nanoseconds(double seconds, double simplices) {
  return seconds > 0 ? fmt::format("{:.0f}", seconds / simplices * 1e9) : "";
}

std::string times(double theirs, double ours) {
  return theirs > 0 ? fmt::format("{:.1f}", theirs / ours) : "";
}

// What other programs need, in seconds; 0 if they were not asked.
struct Others {
  double building = 0;
  double is_valid = 0;
  double tetgen = 0;
};

// Returns whether the mesh was found right, and by the fast judge.
bool print_row(const std::string& name, const std::string& claim, const Arrays& arrays,
               const Others& others) {
  const MeshArrays<std::int32_t> bare{.coordinates = arrays.coordinates,
                                      .simplices = arrays.simplices};
  MeshArrays<std::int32_t> given = bare;
  given.neighbors = arrays.neighbors;
  const auto count = static_cast<double>(arrays.simplices.size() / 4);
  const MeshJudgement judgement = judge(claim, given);
  const Cost with = cost_of(claim, given);
  const Cost without = cost_of(claim, bare);
  fmt::print("| {} | {:.0f} | {} | {} | {} | {} | {} | {} | {} | ", name, count,
             in_nanoseconds(with.seconds, count), in_nanoseconds(without.seconds, count),
             in_nanoseconds(others.building, count), in_nanoseconds(others.is_valid, count),
             times(others.is_valid, with.seconds), in_nanoseconds(others.tetgen, count),
             times(others.tetgen, with.seconds));
  fmt::print("{:.1f} | {:.1f} | {:.2f} | {:.2f} | {:.0f} |\n", with.bytes / count,
             without.bytes / count, with.speedup, without.speedup,
             static_cast<double>(judgement.counts.exact_signs) / count * 1000);
  std::fflush(stdout);
  return judgement.holds && judgement.counts.fast;
}

// From files to verdict, by the clock on the wall.
void time_files(const std::string& stem, double building) {
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "circumspect";
  RunTime least{.wall = 1e9};
  for (int i = 0; i < 3; ++i) {
    const RunTime time = run({program, "check", stem + ".ele"});
    if (time.succeeded && time.wall < least.wall) least = time;
  }
  if (!least.succeeded) return;
  fmt::print(
      "\n`.node` and `.ele` text to verdict, random 10^6, `circumspect check`, {} threads: {:.2f} "
      "s "
      "on the wall, {:.2f} s of processor time; CGAL builds it, one thread, in {:.2f} s.\n",
      std::thread::hardware_concurrency(), least.wall, least.processor, building);
}

// `large`: only our own time and CGAL's.
bool time_one(const std::string& name, const std::vector<double>& coordinates,
              const std::string& folder, bool large = false) {
  Arrays arrays;
  Others others;
  double building = 0;
  {
    Cgal cgal;
    const Points points = points_of(coordinates);
    others.building = seconds(
        [&] { building = wall_seconds([&] { cgal.insert(points.begin(), points.end()); }); });
    arrays = arrays_of(coordinates, cgal);
    const auto check = [&] { cgal.is_valid(); };
    others.is_valid = large ? seconds(check) : least_seconds(check);
  }
  const std::string stem = folder + "/mesh";
  if (!large) {
    write_mesh(stem, arrays);
    others.tetgen = tetgen_seconds(stem, "CC");
  }
  const bool right = print_row(name, "delaunay", arrays, others);
  if (name == "random 10^6") time_files(stem, building);
  return right;
}

bool time_constrained_mesh(const std::string& folder) {
  const Arrays arrays = constrained_mesh(folder, 100);
  if (arrays.simplices.empty()) return true;
  write_mesh(folder + "/mesh", arrays);
  return print_row("CDT, claim `triangulation`", "triangulation", arrays,
                   {.tetgen = tetgen_seconds(folder + "/mesh", "C")});
}

}  // namespace

int time_checking(const std::string& wanted) {
  const bool large = wanted == "check-large";
  if (!large && std::string("check").find(wanted) == std::string::npos) return 0;
  fmt::print("\nJudging meshes in arrays: nanoseconds a tetrahedron, one thread\n\n");
  fmt::print(
      "| points | tetrahedra | neighbours given | points and simplices only | CGAL builds it | "
      "CGAL `is_valid` | times ours | `tetgen -rCC` less `tetgen -r` | times ours | bytes, given | "
      "bytes, only | two threads faster, given | only | exact signs in 1000 |\n| --- |");
  for (int i = 0; i < 13; ++i) fmt::print(" ---: |");
  fmt::print("\n");
  const Folder folder;
  int wrong = 0;
  const auto time = [&](const std::string& name, const std::vector<double>& coordinates) {
    wrong += time_one(name, coordinates, folder.name()) ? 0 : 1;
  };
  time("random 10^4", random_points(10000));
  time("random 10^5", random_points(100000));
  time("grid 46^3", grid_points(46));
  time("sphere 10^5", sphere_points(100000));
  time("100 clusters of 1000", clustered_points(100, 1000));
  time("10^5 near a line", points_near_line(100000));
  time("1000 near two skew lines", points_near_two_lines(1000));
  wrong += time_constrained_mesh(folder.name()) ? 0 : 1;
  time("random 10^6", random_points(1000000));
  if (large) wrong += time_one("random 10^7", random_points(10000000), folder.name(), true) ? 0 : 1;
  return wrong;
}

}  // namespace circumspect::bench
