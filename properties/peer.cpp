// Runs one of the adapters as a program, so that `circumspect campaign` can put it to the test:
//
//     peer cgal-delaunay-3 IN.node OUT.ele         and the other names below
//     peer cgal-constrained-2 IN.poly OUT.ele      which also writes OUT.node and OUT.edge
//
// It reads only what campaigns write, and shares no code with the oracle.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {
namespace {

struct Input {
  PointArray points;
  Segments segments = {};
  std::int64_t first_index = 0;
};

// Numbers one after the other, comments left out. By strtod, since streams refuse subnormal
// numbers.
class Numbers {
 public:
  explicit Numbers(const std::string& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
      text_ << line.substr(0, line.find('#')) << '\n';
  }
  double next() {
    std::string word;
    return text_ >> word ? std::strtod(word.c_str(), nullptr) : 0.0;
  }
  std::int64_t next_integer() { return static_cast<std::int64_t>(next()); }
  std::size_t next_count() { return static_cast<std::size_t>(next()); }

 private:
  std::stringstream text_;
};

Input read(const std::string& path) {
  Numbers numbers(path);
  Input input;
  const std::size_t count = numbers.next_count();
  input.points.dimension = numbers.next_count();
  const std::size_t attributes = numbers.next_count();
  const std::size_t markers = numbers.next_count();
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t index = numbers.next_integer();
    if (i == 0) input.first_index = index;
    for (std::size_t c = 0; c < input.points.dimension; ++c) {
      input.points.coordinates.push_back(numbers.next());
    }
    for (std::size_t a = 0; a < attributes; ++a) {
      const double attribute = numbers.next();
      if (a == 0) input.points.weights.push_back(attribute);
    }
    for (std::size_t m = 0; m < markers; ++m) numbers.next();
  }
  if (std::filesystem::path(path).extension() != ".poly") return input;
  const std::size_t segments = numbers.next_count();
  const std::size_t segment_markers = numbers.next_count();
  for (std::size_t i = 0; i < segments; ++i) {
    numbers.next();
    const std::int64_t a = numbers.next_integer() - input.first_index;
    input.segments.push_back({a, numbers.next_integer() - input.first_index});
    for (std::size_t m = 0; m < segment_markers; ++m) numbers.next();
  }
  return input;
}

void write_simplices(const std::string& path, const SimplexArray& rows, const Input& input) {
  std::ofstream file(path);
  const std::size_t columns = rows.empty() ? input.points.dimension + 1 : rows.front().size();
  file << rows.size() << ' ' << columns << " 0\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    file << static_cast<std::int64_t>(i) + input.first_index;
    for (const std::int64_t v : rows[i]) file << ' ' << v + input.first_index;
    file << '\n';
  }
}

// Edges, where points in a line have no triangles.
void write_edges(const std::string& path, const SimplexArray& rows, const Input& input) {
  std::ofstream file(path);
  file << rows.size() << " 0\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    file << i << ' ' << rows[i][0] + input.first_index << ' ' << rows[i][1] + input.first_index
         << '\n';
  }
}

void write_points(const std::string& path, const Input& input) {
  std::ofstream file(path);
  file << std::setprecision(std::numeric_limits<double>::max_digits10);
  file << input.points.size() << ' ' << input.points.dimension << " 0 0\n";
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    file << static_cast<std::int64_t>(i) + input.first_index;
    for (std::size_t c = 0; c < input.points.dimension; ++c)
      file << ' ' << input.points.point(i)[c];
    file << '\n';
  }
}

int run(const std::string& name, const std::string& in, const std::string& out) {
  const std::map<std::string, std::function<SimplexArray(const Input&)>> programs = {
      {"cgal-delaunay-2", [](const Input& input) { return cgal_delaunay_2(input.points); }},
      {"cgal-delaunay-3", [](const Input& input) { return cgal_delaunay_3(input.points); }},
      {"cgal-regular-3", [](const Input& input) { return cgal_regular_3(input.points); }},
      {"cgal-constrained-2",
       [](const Input& input) { return cgal_constrained_2(input.points, input.segments); }},
      {"tetgen-library", [](const Input& input) { return tetgen_delaunay(input.points); }},
      {"qhull-library", [](const Input& input) { return qhull_delaunay(input.points); }},
  };
  const auto program = programs.find(name);
  if (program == programs.end()) {
    std::cerr << "peer: expected one of";
    for (const auto& [known, function] : programs) std::cerr << ' ' << known;
    std::cerr << ", found " << name << '\n';
    return 2;
  }
  const Input input = read(in);
  SimplexArray rows = program->second(input);
  if (name == "cgal-constrained-2") {
    const auto beside = [&](const char* extension) {
      return std::filesystem::path(out).replace_extension(extension).string();
    };
    write_points(beside(".node"), input);
    if (!rows.empty() && rows.front().size() == 2) {
      write_edges(beside(".edge"), std::exchange(rows, {}), input);
    }
  }
  write_simplices(out, rows, input);
  return 0;
}

}  // namespace
}  // namespace circumspect::adapters

int main(int count, char** arguments) {
  if (count != 4) {
    std::cerr << "usage: peer NAME IN.node|IN.poly OUT.ele\n";
    return 2;
  }
  try {
    return circumspect::adapters::run(arguments[1], arguments[2], arguments[3]);
  } catch (const std::exception& error) {
    std::cerr << "peer: " << error.what() << '\n';
    return 1;
  }
}
