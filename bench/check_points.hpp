// The point sets on which judging is timed. Doubles, three a point.
#pragma once

#include <vector>

namespace circumspect::bench {

std::vector<double> random_points(int count);
std::vector<double> grid_points(int side);
std::vector<double> sphere_points(int count);
std::vector<double> clustered_points(int clusters, int points_each);  // clusters 10^-4 wide
std::vector<double> points_near_line(int count);                      // within 10^-3 of one long 1
// Half of them near each of two skew lines: tetrahedra quadratic in their number.
std::vector<double> points_near_two_lines(int count);

}  // namespace circumspect::bench
