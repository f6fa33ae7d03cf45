// The benchmark of campaigns: what they cost beside the program that they run.
#pragma once

#include <string>
#include <vector>

namespace circumspect::bench {

// A program of points of space: its arguments, with {points} where the path of its .node file is to
// be, and the name of the mesh that it makes of x.node.
struct Program {
  std::vector<std::string> command = {"tetgen", "-JQ", "{points}"};
  std::string mesh = "x.1.ele";
};

// Prints a table of those whose name contains `wanted`; returns how many campaigns took longer than they
// may. Without the program, a line that says so, and 0.
int time_campaigns(const std::string& wanted, const Program& program);

}  // namespace circumspect::bench
