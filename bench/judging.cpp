#include <chrono>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

#include <circumspect/judgement.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/tables.hpp"
#include "fuzz/harness/cases.hpp"
#include "inputs/cases.hpp"
#include "inputs/in_doubles.hpp"
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

// Returns whether it is fast enough. The answers are made beforehand: a program's own time is not
// that of the harness.
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

namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Rows of numbers, each after its index, up to `columns` of them. The first row says how many there
// are.
template <typename Number>
std::vector<Number> read_rows(const std::string& file, int columns) {
  std::ifstream in(file);
  std::size_t rows = 0;
  in >> rows;
  in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  std::vector<Number> numbers;
  for (std::size_t row = 0; row < rows && in; ++row) {
    std::size_t index = 0;
    in >> index;
    for (int i = 0; i < columns; ++i) {
      Number number{};
      in >> number;
      numbers.push_back(number);
    }
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return numbers;
}

// A cube, and in its middle a square of triangles whose vertices have random heights.
void write_domain(const std::string& file, int side) {
  std::mt19937_64 engine(20260101);
  std::string vertices;
  for (int i = 0; i < 8; ++i) {
    vertices += fmt::format("{} {} {} {}\n", i, i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  const auto name = [side](int row, int column) { return 8 + row * (side + 1) + column; };
  std::string facets =
      "1\n4 0 1 3 2\n1\n4 4 5 7 6\n1\n4 0 1 5 4\n1\n4 2 3 7 6\n1\n4 0 2 6 4\n1\n4 1 3 7 5\n";
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j <= side; ++j) {
      const double height = 0.48 + 0.04 * static_cast<double>(engine() >> 11) * 0x1p-53;
      vertices += fmt::format("{} {} {} {}\n", name(i, j), 0.25 + 0.5 * i / side,
                              0.25 + 0.5 * j / side, height);
      if (i == side || j == side) continue;
      facets += fmt::format("1\n3 {0} {1} {2}\n1\n3 {1} {2} {3}\n", name(i, j), name(i + 1, j),
                            name(i, j + 1), name(i + 1, j + 1));
    }
  }
  std::ofstream(file) << 8 + (side + 1) * (side + 1) << " 3 0 0\n"
                      << vertices << 6 + 2 * side * side << " 0\n"
                      << facets << "0\n";
}

}  // namespace

RunTime run(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  }
  RunTime time;
  pid_t child = 0;
  const auto begin = std::chrono::steady_clock::now();
  const int failed =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return time;
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  time.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  time.processor = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  time.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return time;
}

void write_mesh(const std::string& stem, const Arrays& mesh) {
  const std::size_t points = mesh.coordinates.size() / 3, simplices = mesh.simplices.size() / 4;
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{} 3 0 0\n", points);
  for (std::size_t i = 0; i < points; ++i) {
    const double* x = &mesh.coordinates[3 * i];
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", i, x[0], x[1], x[2]);
  }
  std::ofstream(stem + ".node").write(text.data(), static_cast<std::streamsize>(text.size()));
  text.clear();
  fmt::format_to(std::back_inserter(text), "{} 4 0\n", simplices);
  for (std::size_t i = 0; i < simplices; ++i) {
    const std::int32_t* v = &mesh.simplices[4 * i];
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", i, v[0], v[1], v[2], v[3]);
  }
  std::ofstream(stem + ".ele").write(text.data(), static_cast<std::streamsize>(text.size()));
}

Arrays constrained_mesh(const std::string& folder, int side) {
  const std::string stem = folder + "/domain";
  write_domain(stem + ".poly", side);
  if (!run({"tetgen", "-pYq1.4a0.000005nzQ", stem + ".poly"}).succeeded) return {};
  return {.coordinates = read_rows<double>(stem + ".1.node", 3),
          .simplices = read_rows<std::int32_t>(stem + ".1.ele", 4),
          .neighbors = read_rows<std::int32_t>(stem + ".1.neigh", 4)};
}

}  // namespace circumspect::bench
