// What the benchmarks print: a table each, and how long a piece of work takes.
#pragma once

#include <ctime>
#include <string>
#include <vector>

namespace circumspect::bench {

// ---- Constructions of what a piecewise linear complex needs ----

// Prints a table of those whose name contains `wanted`; returns how many took longer than they may.
int time_constrained(const std::string& wanted);

// ---- A harness in process: drawing small inputs and judging answers ----

// Prints a table of those whose name contains `wanted`; returns how many judged fewer cases a second
// than they must.
int time_judging(const std::string& wanted);

// ---- Campaigns: what they cost beside the program that they run ----

// A program of points of space: its arguments, with {points} where the path of its .node file is to
// be, and the name of the mesh that it makes of x.node.
struct Program {
  std::vector<std::string> command = {"tetgen", "-JQ", "{points}"};
  std::string mesh = "x.1.ele";
};

// Prints a table of those whose name contains `wanted`; returns how many campaigns took longer than they
// may. Without the program, a line that says so, and 0.
int time_campaigns(const std::string& wanted, const Program& program);

// ---- Judging a mesh in arrays, beside what the checks of CGAL and TetGen take ----

// Prints a table of nanoseconds a tetrahedron, if "check" contains `wanted`; "check-large": with
// 10^7 points too. Only the rows whose names contain `row`. Then the goals, met or missed. Throws if a
// mesh of CGAL's is not found right.
void time_checking(const std::string& wanted, const std::string& row);

// Processor time: other programs on the machine do not count.
template <typename Work>
double seconds(const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace circumspect::bench
