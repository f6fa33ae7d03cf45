#include "kernel/complex/improper_intersection.hpp"

#include <algorithm>

#include "kernel/exact/linear_algebra.hpp"

namespace circumspect {

namespace {

// A quick and exact "no": the smallest boxes around the simplices are disjoint.
bool boxes_are_disjoint(const std::vector<Point>& a, const std::vector<Point>& b) {
  for (std::size_t axis = 0; axis < a.front().size(); ++axis) {
    const auto by_axis = [axis](const Point& p, const Point& q) { return p[axis] < q[axis]; };
    const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), by_axis);
    const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), by_axis);
    if ((*a_high)[axis] < (*b_low)[axis] || (*b_high)[axis] < (*a_low)[axis]) return true;
  }
  return false;
}

// Variables: barycentric coordinates λ in a, then μ in b. Equations: Σ λ a = Σ μ b, Σ λ = Σ μ = 1.
LinearProgram common_points(const std::vector<Point>& a, const std::vector<Point>& b) {
  const std::size_t dimension = a.front().size();
  const std::size_t variables = a.size() + b.size();
  LinearProgram program;
  program.equations.assign(dimension + 2, std::vector<Rational>(variables, Rational(0)));
  program.right_sides.assign(dimension + 2, Rational(0));
  program.objective.assign(variables, Rational(0));
  for (std::size_t i = 0; i < variables; ++i) {
    const bool in_a = i < a.size();
    const Point& vertex = in_a ? a[i] : b[i - a.size()];
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      program.equations[axis][i] = in_a ? vertex[axis] : Rational(-vertex[axis]);
    }
    program.equations[dimension + (in_a ? 0 : 1)][i] = 1;
  }
  program.right_sides[dimension] = 1;
  program.right_sides[dimension + 1] = 1;
  return program;
}

}  // namespace

std::optional<Point> improper_intersection(const std::vector<Point>& a,
                                           const std::vector<Point>& b) {
  if (boxes_are_disjoint(a, b)) return std::nullopt;
  LinearProgram program = common_points(a, b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    program.objective[i] = std::find(b.begin(), b.end(), a[i]) == b.end() ? 1 : 0;
  }
  const LinearProgramAnswer answer = maximize(program);
  if (answer.status == LinearProgramStatus::kInfeasible || sign(answer.value) == 0) {
    return std::nullopt;
  }
  Point common(a.front().size(), Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) common = common + answer.solution[i] * a[i];
  return common;
}

std::optional<Point> improper_intersection(const PointSet& points, const Simplex& a,
                                           const Simplex& b) {
  return improper_intersection(coordinates(points, a), coordinates(points, b));
}

bool relative_interiors_meet(const std::vector<Point>& a, const std::vector<Point>& b) {
  const LinearProgram program = common_points(a, b);
  return is_solvable(program.equations, program.right_sides, a.size() + b.size());
}

}  // namespace circumspect
