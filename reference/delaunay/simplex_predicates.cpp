#include "reference/delaunay/simplex_predicates.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <vector>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect::delaunay {
namespace {

// All circumballs of a simplex. They are centred on the flat through the centre of the smallest one
// that is orthogonal to the simplex.
struct Circumballs {
  Ball smallest;
  std::vector<Point> directions;  // span the flat, pairwise orthogonal
};

// A vector minus its components along pairwise orthogonal vectors.
Point orthogonal_part(Point vector, const std::vector<Point>& orthogonal) {
  for (const Point& other : orthogonal) {
    const Rational factor = inner_product(vector, other) / squared_length(other);
    vector = vector - factor * other;
  }
  return vector;
}

Circumballs circumballs(const PointSet& points, const Simplex& simplex) {
  const Point& origin = points[simplex.front()];
  std::vector<Point> orthogonal;
  const auto extend_by = [&](Vertex v) {
    const Point direction = orthogonal_part(points[v] - origin, orthogonal);
    if (sign(squared_length(direction)) != 0) orthogonal.push_back(direction);
  };
  for (const Vertex v : simplex) extend_by(v);
  const auto within_simplex = static_cast<std::ptrdiff_t>(orthogonal.size());
  assert(orthogonal.size() + 1 == simplex.size());
  for (const std::size_t i : points.configuration().hull().basis) extend_by(static_cast<Vertex>(i));
  return {circumball(points, simplex), {orthogonal.begin() + within_simplex, orthogonal.end()}};
}

// How fast the power of q falls as the centre moves along a direction: with σ's vertex v staying on
// the sphere, power(c + n, q) = power(c, q) − 2 n·(q − v).
Rational descent(const PointSet& points, const Simplex& simplex, const Point& direction, Vertex q) {
  return 2 * inner_product(direction, points[q] - points[simplex.front()]);
}

struct RoomiestBall {
  Ball ball;
  Rational slack;  // the least power among the points in play, but no more than 1
};

// The circumball that keeps the points in play as far outside as possible. Variables, all ≥ 0: the
// steps t along the directions and their opposites, the slack and its opposite, and the slack
// variable of each inequality: Σ t descent(q) + slack ≤ power(q) for each q, and slack ≤ 1.
RoomiestBall roomiest_ball(const PointSet& points, const Simplex& simplex, const Circumballs& all,
                           const Simplex& in_play) {
  const std::size_t directions = all.directions.size();
  const std::size_t slack = 2 * directions;
  const std::size_t variables = slack + 2 + in_play.size() + 1;
  LinearProgram program;
  program.objective.assign(variables, Rational(0));
  program.objective[slack] = 1;
  program.objective[slack + 1] = -1;
  for (std::size_t row = 0; row <= in_play.size(); ++row) {
    std::vector<Rational> equation = program.objective;
    equation[slack + 2 + row] = 1;
    for (std::size_t j = 0; row < in_play.size() && j < directions; ++j) {
      equation[2 * j] = descent(points, simplex, all.directions[j], in_play[row]);
      equation[2 * j + 1] = -equation[2 * j];
    }
    program.equations.push_back(std::move(equation));
    program.right_sides.push_back(row < in_play.size() ? power(points, all.smallest, in_play[row])
                                                       : Rational(1));
  }
  const LinearProgramAnswer answer = maximize(program);
  assert(answer.status == LinearProgramStatus::kOptimal);
  Point centre = all.smallest.centre;
  for (std::size_t j = 0; j < directions; ++j) {
    const Rational step = answer.solution[2 * j] - answer.solution[2 * j + 1];
    centre = centre + step * all.directions[j];
  }
  const Vertex v = simplex.front();
  const Rational squared_radius = squared_distance(points[v], centre) - points.weight(v);
  return {{centre, squared_radius}, answer.value};
}

// The point of S, other than the vertices of σ, with the least power; nothing if there is none.
std::optional<Vertex> deepest_point(const PointSet& points, const Simplex& simplex,
                                    const Ball& ball) {
  std::optional<Vertex> deepest;
  Rational least;
  for (Vertex q = 0; points.names(q); ++q) {
    if (contains(simplex, q)) continue;
    const Rational here = power(points, ball, q);
    if (!deepest || here < least) {
      deepest = q;
      least = here;
    }
  }
  return deepest;
}

// The dual program: coefficients λ ≥ 0 with Σ λ = 1 and Σ λ descent = 0 along every direction, so
// that Σ λ q lies in the affine hull of σ, that make Σ λ power(q) least. By linear programming
// duality that is the greatest slack.
Obstruction obstruction(const PointSet& points, const Simplex& simplex, const Circumballs& all,
                        const Simplex& in_play) {
  LinearProgram program;
  for (const Point& direction : all.directions) {
    program.equations.emplace_back();
    program.right_sides.emplace_back(0);
    for (const Vertex q : in_play) {
      program.equations.back().push_back(descent(points, simplex, direction, q));
    }
  }
  program.equations.emplace_back(in_play.size(), Rational(1));
  program.right_sides.emplace_back(1);
  for (const Vertex q : in_play) {
    program.objective.push_back(-power(points, all.smallest, q));
  }
  const LinearProgramAnswer answer = maximize(program);
  assert(answer.status == LinearProgramStatus::kOptimal);
  Obstruction found{{}, {}, -answer.value};
  for (std::size_t i = 0; i < in_play.size(); ++i) {
    if (sign(answer.solution[i]) == 0) continue;
    found.points.push_back(in_play[i]);
    found.coefficients.push_back(answer.solution[i]);
  }
  return found;
}

}  // namespace

// Points come into play one by one, always the point that the current ball keeps out least, until
// the ball keeps all points out as far as those in play: then no ball does better.
SimplexDelaunayhood delaunayhood(const PointSet& points, const Simplex& simplex) {
  const Circumballs all = circumballs(points, simplex);
  Simplex in_play;
  RoomiestBall best{all.smallest, 1};
  for (std::optional<Vertex> q; (q = deepest_point(points, simplex, best.ball)) &&
                                power(points, best.ball, *q) < best.slack;) {
    in_play.push_back(*q);
    best = roomiest_ball(points, simplex, all, in_play);
  }
  if (sign(best.slack) > 0) return {Delaunayhood::kStronglyDelaunay, best.ball, std::nullopt};
  const Obstruction why = obstruction(points, simplex, all, in_play);
  assert(why.power == best.slack);
  if (sign(best.slack) == 0) return {Delaunayhood::kDelaunay, best.ball, why};
  return {Delaunayhood::kNotDelaunay, std::nullopt, why};
}

bool is_delaunay(const PointSet& points, const Simplex& simplex) {
  return delaunayhood(points, simplex).delaunayhood != Delaunayhood::kNotDelaunay;
}

bool is_strongly_delaunay(const PointSet& points, const Simplex& simplex) {
  return delaunayhood(points, simplex).delaunayhood == Delaunayhood::kStronglyDelaunay;
}

bool is_delaunay(const PointSet& points, const Triangulation& triangulation) {
  return std::all_of(triangulation.simplices().begin(), triangulation.simplices().end(),
                     [&](const Simplex& simplex) { return is_delaunay(points, simplex); });
}

}  // namespace circumspect::delaunay
