#include "oracle/judge/domain/empty_circumball.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect::check {

namespace {

// Directions that span what is orthogonal to the simplex.
std::vector<Point> normals(const PointSet& points, const Simplex& simplex) {
  const Point edge = points[simplex[1]] - points[simplex[0]];
  if (simplex.size() == 3) return {cross_product(edge, points[simplex[2]] - points[simplex[0]])};
  std::size_t axis = 0;
  while (sign(edge[axis]) == 0) ++axis;
  std::vector<Point> directions;
  for (std::size_t other = 0; other < edge.size(); ++other) {
    if (other == axis) continue;
    Point direction(edge.size(), Rational(0));
    direction[other] = edge[axis];
    direction[axis] = -edge[other];
    directions.push_back(direction);
  }
  return directions;
}

// The circumballs of a simplex: centre c + Σ λ_i n_i. A vertex q is not strictly inside one iff
// Σ λ_i 2 n_i·(q − c) ≤ |q − c|² − r².
class Circumballs {
 public:
  Circumballs(const PointSet& points, const Simplex& simplex)
      : points_(points),
        simplex_(simplex),
        smallest_(circumball(points, simplex)),
        normals_(normals(points, simplex)) {}

  Ball at(const std::vector<Rational>& lambda) const {
    Ball ball = smallest_;
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      ball.centre = ball.centre + lambda[i] * normals_[i];
    }
    ball.squared_radius = squared_distance(ball.centre, points_[simplex_.front()]);
    return ball;
  }

  // Some λ for which no vertex of the list is strictly inside, found as λ⁺ − λ⁻ with a slack for
  // each vertex.
  std::optional<std::vector<Rational>> clear_of(const std::vector<Vertex>& vertices) const {
    const std::size_t m = normals_.size();
    LinearProgram program;
    program.objective.assign(2 * m + vertices.size(), Rational(0));
    for (std::size_t row = 0; row < vertices.size(); ++row) {
      const Point away = points_[vertices[row]] - smallest_.centre;
      std::vector<Rational> equation(2 * m + vertices.size(), Rational(0));
      for (std::size_t i = 0; i < m; ++i) {
        equation[i] = 2 * inner_product(normals_[i], away);
        equation[m + i] = -equation[i];
      }
      equation[2 * m + row] = 1;
      program.equations.push_back(equation);
      program.right_sides.push_back(power(points_, smallest_, vertices[row]));
    }
    const LinearProgramAnswer answer = maximize(program);
    if (answer.status == LinearProgramStatus::kInfeasible) return std::nullopt;
    std::vector<Rational> lambda(m);
    for (std::size_t i = 0; i < m; ++i) lambda[i] = answer.solution[i] - answer.solution[m + i];
    return lambda;
  }

  std::size_t freedom() const { return normals_.size(); }

 private:
  const PointSet& points_;
  const Simplex& simplex_;
  Ball smallest_;
  std::vector<Point> normals_;
};

// The vertex deepest inside a ball, if any is strictly inside.
std::optional<Vertex> deepest(const PointSet& points, const Ball& ball, const Simplex& simplex,
                              const std::vector<Vertex>& candidates) {
  std::optional<Vertex> found;
  Rational least = 0;
  for (const Vertex v : candidates) {
    if (contains(simplex, v)) continue;
    const Rational at = power(points, ball, v);
    if (at >= least) continue;
    least = at;
    found = v;
  }
  return found;
}

}  // namespace

std::vector<Vertex> vertices_in_every_circumball(const PointSet& points, const Simplex& simplex,
                                                 const VerticesNear& near) {
  const Circumballs balls(points, simplex);
  std::vector<Vertex> against;
  std::vector<Rational> lambda(balls.freedom(), Rational(0));
  while (true) {
    const Ball ball = balls.at(lambda);
    const auto inside = deepest(points, ball, simplex, near(ball));
    if (!inside) return {};
    against.push_back(*inside);
    auto next = balls.clear_of(against);
    if (!next) break;
    lambda = std::move(*next);
  }
  // Leave out what the others do without (by Helly's theorem d − j + 1 of them are enough).
  for (std::size_t i = 0; i < against.size();) {
    std::vector<Vertex> fewer = against;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (balls.clear_of(fewer)) {
      ++i;
    } else {
      against = std::move(fewer);
    }
  }
  return against;
}

}  // namespace circumspect::check
