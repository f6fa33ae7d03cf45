// What judging a mesh in arrays may cost, and the table that says where that is so.
#pragma once

#include <string>
#include <vector>

namespace circumspect::bench {

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

}  // namespace circumspect::bench
