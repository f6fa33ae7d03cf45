// The point sets that the benchmarks run on; the same on every machine.
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect::bench {

// Doubles with 53 random bits, uniform in the unit cube [0, 1)^d.
std::vector<Point> random_in_cube(std::size_t count, std::size_t dimension);

// side³ points (x, y, z), 0 ≤ x, y, z < side. Far from generic.
std::vector<Point> cubic_grid(int side);

// The same grid in an order that makes incremental insertion change much: the square at the bottom
// first, then the rest column by column, each column from the top downwards. Every vertex comes
// lower than those above it, so it takes over the tetrahedra between them and the bottom.
// Book: Chapter 5, Exercise 1.
std::vector<Point> cubic_grid_adversarial(int side);

// Those on which judging is timed. Doubles, three a point.

std::vector<double> random_points(int count);
std::vector<double> grid_points(int side);
std::vector<double> sphere_points(int count);
std::vector<double> clustered_points(int clusters, int points_each);  // clusters 10^-4 wide
std::vector<double> points_near_line(int count);                      // within 10^-3 of one long 1
// Half of them near each of two skew lines: tetrahedra quadratic in their number.
std::vector<double> points_near_two_lines(int count);

}  // namespace circumspect::bench
