// How long it takes to judge a mesh in arrays, beside what the checks of CGAL and TetGen take.
#pragma once

#include <string>

namespace circumspect::bench {

// Prints a table of nanoseconds a tetrahedron, if "check" contains `wanted`; "check-large": with
// 10^7 points too. Returns how many meshes were judged wrong.
int time_checking(const std::string& wanted);

}  // namespace circumspect::bench
