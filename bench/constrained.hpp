// The benchmarks of what a piecewise linear complex needs.
#pragma once

#include <string>

namespace circumspect::bench {

// Prints a table of those whose name contains `wanted`; returns how many took longer than they may.
int time_constrained(const std::string& wanted);

}  // namespace circumspect::bench
