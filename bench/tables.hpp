// What the benchmarks print: a table each, and how long a piece of work takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::bench {

// Prints a table of those whose name contains `wanted`; returns how many took longer than they may.
int time_constrained(const std::string& wanted);

// Prints a table of those whose name contains `wanted`; returns how many judged fewer cases a
// second than they must.
int time_judging(const std::string& wanted);

// A program of points of space: its arguments, with {points} where the path of its .node file is to
// be, and the name of the mesh that it makes of x.node.
struct Program {
  std::vector<std::string> command = {"tetgen", "-JQ", "{points}"};
  std::string mesh = "x.1.ele";
};

// Prints a table of those whose name contains `wanted`; returns how many campaigns took longer than
// they may. Without the program, a line that says so, and 0.
int time_campaigns(const std::string& wanted, const Program& program);

// Prints a table of nanoseconds a tetrahedron, if "check" contains `wanted`; "check-large": with
// 10^7 points too. Only the rows whose names contain `row`. Then the goals, met or missed. Throws
// if a mesh of CGAL's is not found right.
void time_checking(const std::string& wanted, const std::string& row);

// Processor time: other programs on the machine do not count.
template <typename Work>
double seconds(const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// What judging a mesh in arrays may cost, and the table that says where that is so.

// Of one mesh. Times are nanoseconds of one thread a simplex; 0 where it was not measured.
struct Measured {
  std::string name;
  double given = 0;          // with neighbours
  double only = 0;           // without
  double is_valid = 0;       // CGAL's time
  double given_speedup = 0;  // of two threads against one, by the clock on the wall
  double only_speedup = 0;
  double bytes = 0;  // beside the arrays, at most at a time, a simplex; the larger of both
  double text_to_verdict = 0;  // seconds
};

// Prints a row for each goal and a column for each mesh that has goals: met, or missed by how much.
void print_goals(const std::vector<Measured>& meshes);

// Meshes in TetGen's files, and other programs that read them.

// A mesh as circumspect::MeshArrays wants it. Indices from 0, −1 where there is no neighbour.
struct Arrays {
  std::vector<double> coordinates;
  std::vector<std::int32_t> simplices;
  std::vector<std::int32_t> neighbors;
};

struct RunTime {
  double processor = 0;  // seconds, of the program and the system for it
  double wall = 0;
  bool succeeded = false;  // exit code 0
};

// Runs the program, found in PATH, and drops what it prints.
RunTime run(const std::vector<std::string>& command);

// Writes `stem`.node and `stem`.ele.
void write_mesh(const std::string& stem, const Arrays& mesh);

// What `tetgen -pYq1.4a0.000005` makes of a cube with a folded surface of 2·side² triangles in its
// middle: the triangles stay, so it is not Delaunay. Empty if TetGen is not there. Leaves files in
// the folder.
Arrays constrained_mesh(const std::string& folder, int side);

// The constructions that the benchmarks compare.

struct Algorithm {
  std::string name;
  std::function<Triangulation(const PointSet&)> construct;
  // The numbers of points to try, and the seconds that the last may take (0: any).
  std::vector<std::size_t> sizes;
  int seconds_allowed = 0;
};

// One line an algorithm.
const std::vector<Algorithm>& algorithms();

}  // namespace circumspect::bench
