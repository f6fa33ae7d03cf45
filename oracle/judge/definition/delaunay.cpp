#include "oracle/judge/definition/delaunay.hpp"

#include <algorithm>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::definition {

void judge_balls_are_empty(const ExactMesh& mesh, Verdict& verdict) {
  const Configuration& points = mesh.points.configuration();
  const Rule rule = mesh.points.is_weighted() ? Rule::kPointBelowPlane : Rule::kVertexInBall;
  bool unique = true, canonical = true;
  for (const Simplex& simplex : mesh.simplices) {
    for (Vertex q = 0; mesh.points.names(q); ++q) {
      if (contains(simplex, q)) continue;
      const int side = in_ball(points, simplex, q);
      if (side > 0) add_vertex_in_ball(mesh.points, rule, simplex, std::nullopt, q, verdict);
      if (side != 0) continue;
      unique = false;
      canonical = canonical && perturbed_in_ball(points, simplex, q) < 0;
    }
  }
  if (!verdict.holds()) return;
  verdict.unique = unique;
  verdict.canonical = canonical;
}

namespace {

// Do all open circumballs of the simplex contain one of these points? A ball is its centre x:
// equally far from the vertices p, p_1, …, p_k of the simplex, and no farther from them than from
// each point q. |x − p|² and |x − q|² differ by what is linear in x, so that is a linear program:
//     2 (p_i − p)·x = |p_i|² − |p|²      2 (q − p)·x ≤ |q|² − |p|²
// The unknowns may not be negative: x = x⁺ − x⁻, and one more for each inequality.
bool every_ball_has_one_of(const PointSet& points, const Simplex& simplex,
                           const std::vector<Vertex>& some) {
  const Point& p = points[simplex.front()];
  const std::size_t d = p.size();
  RationalMatrix rows;
  std::vector<Rational> right;
  const auto add_row = [&](const Point& q) {
    std::vector<Rational>& row = rows.emplace_back(2 * d + some.size(), 0);
    for (std::size_t axis = 0; axis < d; ++axis) {
      row[axis] = 2 * (q[axis] - p[axis]);
      row[d + axis] = -row[axis];
    }
    right.push_back(squared_length(q) - squared_length(p));
  };
  for (std::size_t i = 1; i < simplex.size(); ++i) add_row(points[simplex[i]]);
  for (std::size_t i = 0; i < some.size(); ++i) {
    add_row(points[some[i]]);
    rows.back()[2 * d + i] = 1;
  }
  return !is_solvable(rows, right);
}

}  // namespace

void judge_some_ball_is_empty(const PointSet& points, const std::vector<Simplex>& simplices,
                              Verdict& verdict) {
  for (const Simplex& simplex : simplices) {
    std::vector<Vertex> against = all_vertices(points);
    std::erase_if(against, [&](Vertex v) { return contains(simplex, v); });
    if (!every_ball_has_one_of(points, simplex, against)) continue;
    // Of the witness those are left out that the others do without; by Helly's theorem few are
    // left.
    for (const Vertex v : std::vector<Vertex>(against)) {
      std::vector<Vertex> fewer = against;
      std::erase(fewer, v);
      if (every_ball_has_one_of(points, simplex, fewer)) against = fewer;
    }
    verdict.add(Rule::kNoEmptyBall,
                {.simplices = {simplex}, .vertices = against, .ball = circumball(points, simplex)});
  }
}

}  // namespace circumspect::definition
