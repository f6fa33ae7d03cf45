// Linear algebra over the rationals from the definitions: slow, short, and independent of the code
// under test.
#pragma once

#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect::generators {

// All k-subsets of {0, …, n−1}, each ascending. Requires: k <= n.
std::vector<std::vector<std::size_t>> subsets(std::size_t n, std::size_t k);

// Leibniz's formula, a sum over all permutations; 1 for no row. Requires: a square matrix.
Rational leibniz_determinant(const std::vector<Point>& rows);

// The order of the largest minor that is not zero.
std::size_t rank_by_minors(const std::vector<Point>& rows);

// The affine dimension of points by minors; -1 for none.
int dimension_by_minors(const std::vector<Point>& points);

// The points projected on the given axes.
std::vector<Point> projected(const std::vector<Point>& points,
                             const std::vector<std::size_t>& axes);

// By Cramer's rule. Requires: a square matrix with determinant not zero.
Point cramer_solution(const std::vector<Point>& rows, const Point& right_hand_side);

// The point of aff(simplex) with the same power |o − p_i|² − w_i to all vertices, and that power:
// the circumcentre and the squared radius when there are no weights.
struct PowerBall {
  Point centre;
  Rational squared_radius;
};
// Requires: affinely independent; weights as long as simplex.
PowerBall power_ball(const std::vector<Point>& simplex, const std::vector<Rational>& weights);

}  // namespace circumspect::generators
