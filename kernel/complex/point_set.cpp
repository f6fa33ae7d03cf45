#include "kernel/complex/point_set.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "kernel/exact/interruption.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {

namespace {

// Equal points would have consecutive ranks.
bool are_different(const std::vector<Point>& points, const Configuration& configuration) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t v = 0; v < order.size(); ++v) {
    order[configuration.rank(static_cast<Vertex>(v))] = v;
  }
  return std::adjacent_find(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
           return points[a] == points[b];
         }) == order.end();
}

}  // namespace

std::vector<Duplicate> duplicates(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    end_if_interrupted();
    return points[a] < points[b];
  });
  std::vector<Duplicate> found;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i + 1;
    for (; j < order.size() && points[order[j]] == points[order[i]]; ++j) {
      found.push_back({static_cast<Vertex>(order[i]), static_cast<Vertex>(order[j])});
    }
    i = j;
  }
  std::sort(found.begin(), found.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.again < b.again; });
  return found;
}

PointSet::PointSet(std::vector<Point> points, std::vector<Rational> weights)
    : points_(std::move(points)), weights_(std::move(weights)), configuration_(points_, weights_) {
  assert(are_different(points_, configuration_));
}

std::vector<Point> coordinates(const PointSet& points, const Simplex& simplex) {
  std::vector<Point> vertices;
  vertices.reserve(simplex.size());
  for (const Vertex v : simplex) vertices.push_back(points[v]);
  return vertices;
}

Simplex positively_oriented(const PointSet& points, Simplex simplex) {
  if (orientation(points.configuration(), simplex) < 0) std::swap(simplex[0], simplex[1]);
  return simplex;
}

Flat flat_through(const PointSet& points, const std::vector<Vertex>& members) {
  std::vector<std::size_t> axes(points.ambient_dimension());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  return flat_through(points, axes, members);
}

Flat flat_through(const PointSet& points, const std::vector<std::size_t>& axes,
                  const std::vector<Vertex>& members) {
  assert(!members.empty());
  std::vector<Point> projections;
  for (const Vertex v : members) {
    Point projection;
    for (const std::size_t axis : axes) projection.push_back(points[v][axis]);
    projections.push_back(std::move(projection));
  }
  const AffineHull hull = affine_hull(projections);
  Flat flat;
  for (const std::size_t i : hull.basis) flat.basis.push_back(members[i]);
  for (const std::size_t i : hull.axes) flat.axes.push_back(axes[i]);
  return flat;
}

std::vector<Vertex> all_vertices(const PointSet& points) {
  std::vector<Vertex> all(points.size());
  std::iota(all.begin(), all.end(), Vertex{0});
  return all;
}

Ball circumball(const PointSet& points, const Simplex& simplex) {
  assert(!simplex.empty());
  const Vertex first = simplex.front();
  const std::size_t k = simplex.size() - 1;
  std::vector<Point> edges;
  for (std::size_t i = 1; i <= k; ++i) edges.push_back(points[simplex[i]] - points[first]);
  // The centre is p_0 + Σ t_j e_j with 2 e_i·(centre − p_0) = |e_i|² − w_i + w_0 for every edge.
  RationalMatrix gram(k, std::vector<Rational>(k));
  std::vector<Rational> right(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) gram[i][j] = 2 * inner_product(edges[i], edges[j]);
    right[i] = squared_length(edges[i]) - points.weight(simplex[i + 1]) + points.weight(first);
  }
  const auto t = solve(gram, right);
  assert(t.has_value());
  Ball ball{points[first], 0};
  for (std::size_t j = 0; j < k; ++j) ball.centre = ball.centre + (*t)[j] * edges[j];
  ball.squared_radius = squared_distance(points[first], ball.centre) - points.weight(first);
  return ball;
}

Rational power(const PointSet& points, const Ball& ball, Vertex q) {
  return squared_distance(points[q], ball.centre) - points.weight(q) - ball.squared_radius;
}

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

std::optional<Point> improper_intersection(const PointSet& points, const Simplex& a,
                                           const Simplex& b) {
  const std::vector<Point> a_points = coordinates(points, a);
  const std::vector<Point> b_points = coordinates(points, b);
  if (boxes_are_disjoint(a_points, b_points)) return std::nullopt;
  LinearProgram program = common_points(a_points, b_points);
  for (std::size_t i = 0; i < a.size(); ++i) program.objective[i] = contains(b, a[i]) ? 0 : 1;
  const LinearProgramAnswer answer = maximize(program);
  if (answer.status == LinearProgramStatus::kInfeasible || sign(answer.value) == 0) {
    return std::nullopt;
  }
  Point common(a_points.front().size(), Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) common = common + answer.solution[i] * a_points[i];
  return common;
}

}  // namespace circumspect
