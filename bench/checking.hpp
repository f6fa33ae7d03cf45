// How long it takes to judge a mesh in arrays, beside what the checks of CGAL and TetGen take.
#pragma once

#include <string>

namespace circumspect::bench {

// Prints a table of nanoseconds a tetrahedron, if "check" contains `wanted`; "check-large": with
// 10^7 points too. Only the rows whose names contain `row`. Then the goals, met or missed. Throws if a
// mesh of CGAL's is not found right.
void time_checking(const std::string& wanted, const std::string& row);

}  // namespace circumspect::bench
