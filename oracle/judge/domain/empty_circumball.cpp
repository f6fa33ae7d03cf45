#include "oracle/judge/domain/empty_circumball.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect::check {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Box> boxes_of(const PointSet& points) {
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const Point& point : points.points()) boxes.push_back(box_around(point));
  return boxes;
}

std::array<double, 3> first_three(const std::array<double, 9>& sides) {
  return {sides[0], sides[1], sides[2]};
}

// A box around the ball along the axes; its edges are not cut off. Every operation on doubles is
// followed by one step outward, more than it can have rounded inward.
Box box_of_ball(const Ball& ball) {
  Box box = box_around(ball.centre);
  const double radius = std::nextafter(std::sqrt(upper_double(ball.squared_radius)), kInfinity);
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    const bool along_axis = i < ball.centre.size() && std::isfinite(radius);
    box.low[i] = along_axis ? std::nextafter(box.low[i] - radius, -kInfinity) : -kInfinity;
    box.high[i] = along_axis ? std::nextafter(box.high[i] + radius, kInfinity) : kInfinity;
  }
  return box;
}

}  // namespace

VertexIndex::VertexIndex(const PointSet& points) : VertexIndex(boxes_of(points)) {}

VertexIndex::VertexIndex(const std::vector<Box>& boxes) : index_(boxes) {
  for (const Box& box : boxes) {
    low_.push_back(first_three(box.low));
    high_.push_back(first_three(box.high));
  }
}

// A vertex and the centre are at least the gap between their boxes apart, on each axis. A gap, its square
// and the two sums are rounded, each by at most a part 2⁻⁵³ of it or 2⁻¹⁰⁷⁵: the sum of squares is too large
// by at most a part 6 · 2⁻⁵³ and 8 · 2⁻¹⁰⁷⁵. What is beyond `far` is therefore outside, if nothing overflowed.
std::vector<Vertex> VertexIndex::near(const Ball& ball) const {
  const Box centre = box_around(ball.centre);
  const double far = upper_double(ball.squared_radius) * (1 + 0x1p-49) + 0x1p-1060;
  const auto is_beyond = [&](std::size_t place) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double gap =
          std::max({0.0, low_[place][i] - centre.high[i], centre.low[i] - high_[place][i]});
      sum += gap * gap;
    }
    return sum > far && std::isfinite(sum);
  };
  std::vector<Vertex> vertices;
  for (const std::size_t place : index_.meeting(box_of_ball(ball))) {
    if (!is_beyond(place)) vertices.push_back(static_cast<Vertex>(place));
  }
  return vertices;
}

// ---- Empty circumball ----

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
