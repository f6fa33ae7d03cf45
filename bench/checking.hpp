// How long it takes to judge a mesh in arrays, beside what CGAL's own check takes.
#pragma once

#include <string>

namespace circumspect::bench {

// Prints a table of nanoseconds a tetrahedron, if "check" contains `wanted`. Returns how many meshes were
// judged wrong.
int time_checking(const std::string& wanted);

}  // namespace circumspect::bench
