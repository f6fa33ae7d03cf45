#include "bench/tables.hpp"

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

#include "bench/point_sets.hpp"

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
  // What takes a twentieth of a second is soon disturbed, and soon repeated.
  const int runs = cost.seconds < 0.2 ? 20 : 6;
  double best[2] = {1e9, 1e9};
  for (int i = 0; i < runs; ++i) {
    const unsigned threads = i % 2 == 0 ? 1 : 2;
    best[i % 2] =
        std::min(best[i % 2], wall_seconds([&] { judge(claim, mesh, {.threads = threads}); }));
  }
  cost.speedup = best[0] / best[1];
  return cost;
}

// What -C or -CC costs TetGen: it reads the files, and builds its mesh of them, with and without
// it.
struct TetgenTime {
  double seconds = 0;  // 0 if there is nothing to compare with
  std::string why_not = {};
};

TetgenTime tetgen_time(const std::string& stem, const std::string& check) {
  double least[2] = {1e9, 1e9};
  for (int i = 0; i < 6; ++i) {
    const std::string options = "-rNEFQ" + (i % 2 == 0 ? "" : check);
    const RunTime time = run({"tetgen", options, stem + ".ele"});
    if (!time.succeeded) return {.why_not = "`" + options + "` fails"};
    least[i % 2] = std::min(least[i % 2], time.processor);
  }
  if (least[1] <= least[0]) return {.why_not = "no difference"};
  return {.seconds = least[1] - least[0]};
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
  double building_on_wall = 0;
  double is_valid = 0;
  TetgenTime tetgen = {};
};

// A row of the table. Throws if the mesh is not found right, by the fast judge.
Measured print_row(const std::string& name, const std::string& claim, const Arrays& arrays,
                   const Others& others) {
  const MeshArrays<std::int32_t> bare{.coordinates = arrays.coordinates,
                                      .simplices = arrays.simplices};
  MeshArrays<std::int32_t> given = bare;
  given.neighbors = arrays.neighbors;
  const auto count = static_cast<double>(arrays.simplices.size() / 4);
  const MeshJudgement judgement = judge(claim, given);
  if (!judgement.holds || !judgement.counts.fast) {
    throw std::runtime_error(name + ": " + judgement.counts.why_not_fast + judgement.report);
  }
  const Cost with = cost_of(claim, given);
  const Cost without = cost_of(claim, bare);
  fmt::print("| {} | {:.0f} | {} | {} | {} | {} | {} | {} | {} | ", name, count,
             in_nanoseconds(with.seconds, count), in_nanoseconds(without.seconds, count),
             in_nanoseconds(others.building, count), in_nanoseconds(others.is_valid, count),
             times(others.is_valid, with.seconds),
             others.tetgen.why_not + in_nanoseconds(others.tetgen.seconds, count),
             times(others.tetgen.seconds, with.seconds));
  fmt::print("{:.1f} | {:.1f} | {:.2f} | {:.2f} | {:.0f} |\n", with.bytes / count,
             without.bytes / count, with.speedup, without.speedup,
             static_cast<double>(judgement.counts.exact_signs) / count * 1000);
  std::fflush(stdout);
  const double to_nanoseconds = 1e9 / count;
  return {.name = name,
          .given = with.seconds * to_nanoseconds,
          .only = without.seconds * to_nanoseconds,
          .is_valid = others.is_valid * to_nanoseconds,
          .given_speedup = with.speedup,
          .only_speedup = without.speedup,
          .bytes = std::max(with.bytes, without.bytes) / count};
}

struct Fault {
  std::string name;
  std::function<void(Arrays&)> add;
};

std::vector<Fault> faults() {
  const auto row_in = [](Arrays& arrays, std::size_t part, std::size_t parts) {
    return arrays.simplices.begin() +
           static_cast<std::ptrdiff_t>(arrays.simplices.size() / 4 * part / parts * 4);
  };
  return {
      {"none", [](Arrays&) {}},
      {"an index that names no point", [=](Arrays& a) { *row_in(a, 1, 3) = -1; }},
      {"a vertex twice in one", [=](Arrays& a) { row_in(a, 1, 3)[0] = row_in(a, 1, 3)[1]; }},
      {"one listed twice",
       [=](Arrays& a) {
         const std::vector<std::int32_t> again(row_in(a, 1, 3), row_in(a, 1, 3) + 4);
         a.simplices.insert(a.simplices.end(), again.begin(), again.end());
       }},
      {"a point that is not a vertex",
       [](Arrays& a) {
         a.coordinates.insert(a.coordinates.end(), {0.5, 0.5, 0.5});
       }},
      {"one missing", [=](Arrays& a) { a.simplices.erase(row_in(a, 1, 3), row_in(a, 1, 3) + 4); }},
      {"a vertex moved through a facet",
       [=](Arrays& a) {
         const auto row = row_in(a, 1, 3);
         for (std::size_t axis = 0; axis < 3; ++axis) {
           double& at = a.coordinates[static_cast<std::size_t>(row[0]) * 3 + axis];
           double middle = 0;
           for (std::size_t i = 1; i < 4; ++i) {
             middle += a.coordinates[static_cast<std::size_t>(row[i]) * 3 + axis] / 3;
           }
           at += 1.5 * (middle - at);
         }
       }},
      {"one of 30 missing", [=](Arrays& a) {
         std::vector<std::int32_t> kept;
         for (std::size_t i = 0; i < a.simplices.size(); ++i) {
           if (i / 4 % 30 != 7) kept.push_back(a.simplices[i]);
         }
         a.simplices = std::move(kept);
       }}};
}

// A mesh with one fault after the other, against the same mesh when it holds. Throws if one is not
// found fast.
void print_failing(const std::string& name, const Arrays& good) {
  fmt::print("\n{}, points and simplices only, with something wrong: one thread\n\n", name);
  fmt::print(
      "| what is wrong | first rule broken | nanoseconds a tetrahedron | times the mesh that holds "
      "|");
  fmt::print(" bytes a tetrahedron |\n| --- | --- | ---: | ---: | ---: |\n");
  double holding = 0;
  for (const Fault& fault : faults()) {
    Arrays arrays = good;
    fault.add(arrays);
    const MeshArrays<std::int32_t> mesh{.coordinates = arrays.coordinates,
                                        .simplices = arrays.simplices};
    const MeshJudgement judgement = judge("delaunay", mesh);
    if (!judgement.counts.fast) throw std::runtime_error(fault.name + ": judged slowly");
    const Cost cost = cost_of("delaunay", mesh);
    if (holding == 0) holding = cost.seconds;
    const auto count = static_cast<double>(arrays.simplices.size() / 4);
    fmt::print("| {} | {} | {} | {:.1f} | {:.0f} |\n", fault.name, judgement.rule,
               in_nanoseconds(cost.seconds, count), cost.seconds / holding, cost.bytes / count);
    std::fflush(stdout);
  }
}

// From files to verdict, by the clock on the wall: the least of three.
RunTime time_files(const std::string& stem) {
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "circumspect";
  RunTime least{.wall = 1e9};
  for (int i = 0; i < 3; ++i) {
    const RunTime time = run({program, "check", stem + ".ele"});
    if (time.succeeded && time.wall < least.wall) least = time;
  }
  return least.succeeded ? least : RunTime{};
}

class Table {
 public:
  // Prints rows whose names contain `wanted`.
  explicit Table(std::string wanted) : wanted_(std::move(wanted)) {
    fmt::print("\nJudging meshes in arrays: nanoseconds a tetrahedron, one thread\n\n");
    fmt::print(
        "| points | tetrahedra | neighbours given | points and simplices only | CGAL builds it | "
        "CGAL `is_valid` | times ours | `tetgen -rCC` less `tetgen -r` | times ours | bytes, given "
        "| bytes, only | two threads faster, given | only | exact signs in 1000 |\n| --- |");
    for (int i = 0; i < 13; ++i) fmt::print(" ---: |");
    fmt::print("\n");
  }

  // `large`: CGAL once, and no files. `files`: from files to verdict, too.
  enum class Extent { kUsual, kLarge, kFiles };
  void add(const std::string& name, const std::vector<double>& coordinates,
           Extent extent = Extent::kUsual) {
    if (name.find(wanted_) == std::string::npos) return;
    Others others;
    const Arrays arrays = built(coordinates, extent == Extent::kLarge, others);
    const std::string stem = folder_.name() + "/mesh";
    if (extent != Extent::kLarge) {
      write_mesh(stem, arrays);
      others.tetgen = tetgen_time(stem, "CC");
    }
    meshes_.push_back(print_row(name, "delaunay", arrays, others));
    if (name == "random 10^5") failing_ = arrays;
    if (extent != Extent::kFiles) return;
    text_ = time_files(stem);
    built_in_ = others.building_on_wall;
    meshes_.back().text_to_verdict = text_.wall;
  }

  void add_constrained(const std::string& name) {
    if (name.find(wanted_) == std::string::npos) return;
    const Arrays arrays = constrained_mesh(folder_.name(), 100);
    if (arrays.simplices.empty()) return;
    write_mesh(folder_.name() + "/mesh", arrays);
    print_row(name, "triangulation", arrays,
              {.tetgen = tetgen_time(folder_.name() + "/mesh", "C")});
  }

  void finish() const {
    print_goals(meshes_);
    if (!failing_.simplices.empty()) print_failing("random 10^5", failing_);
    if (!text_.succeeded) return;
    fmt::print(
        "\n`.node` and `.ele` text to verdict, random 10^6, `circumspect check`, {} threads: "
        "{:.2f} s on the wall, {:.2f} s of processor time; CGAL builds it, one thread, in {:.2f} "
        "s.\n",
        std::thread::hardware_concurrency(), text_.wall, text_.processor, built_in_);
  }

 private:
  // CGAL's mesh, and how long it takes CGAL to build and check it.
  static Arrays built(const std::vector<double>& coordinates, bool large, Others& others) {
    Cgal cgal;
    const Points points = points_of(coordinates);
    others.building = seconds([&] {
      others.building_on_wall = wall_seconds([&] { cgal.insert(points.begin(), points.end()); });
    });
    Arrays arrays = arrays_of(coordinates, cgal);
    const auto check = [&] { cgal.is_valid(); };
    others.is_valid = large ? seconds(check) : least_seconds(check);
    return arrays;
  }

  std::string wanted_;
  Folder folder_;
  std::vector<Measured> meshes_;
  Arrays failing_;  // one of them, that faults are added to
  RunTime text_;
  double built_in_ = 0;
};

}  // namespace

void time_checking(const std::string& wanted, const std::string& row) {
  const bool large = wanted == "check-large";
  if (!large && std::string("check").find(wanted) == std::string::npos) return;
  Table table(row);
  table.add("random 10^4", random_points(10000));
  table.add("random 10^5", random_points(100000));
  table.add("grid 46^3", grid_points(46));
  table.add("sphere 10^5", sphere_points(100000));
  table.add("100 clusters of 1000", clustered_points(100, 1000));
  table.add("10^5 near a line", points_near_line(100000));
  table.add("1000 near two skew lines", points_near_two_lines(1000));
  table.add_constrained("CDT, claim `triangulation`");
  table.add("random 10^6", random_points(1000000), Table::Extent::kFiles);
  if (large) table.add("random 10^7", random_points(10000000), Table::Extent::kLarge);
  table.finish();
}

}  // namespace circumspect::bench
