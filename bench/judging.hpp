// The benchmark of a harness in process: drawing small inputs and judging answers.
#pragma once

#include <string>

namespace circumspect::bench {

// Prints a table of those whose name contains `wanted`; returns how many judged fewer cases a second
// than they must.
int time_judging(const std::string& wanted);

}  // namespace circumspect::bench
