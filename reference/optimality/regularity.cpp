#include "reference/optimality/regularity.hpp"

#include <cassert>

#include "reference/kernel/exact/linear_program.hpp"
#include "reference/optimality/barycentric.hpp"

namespace circumspect::optimality {
namespace {

// A point q that must be above the plane through a lifted simplex: h_q − Σ λ_i h_i ≥ 1 for q's
// barycentric coordinates λ. (Any positive bound would do: heights can be scaled.)
std::vector<Rational> height_above(const PointSet& points, const Simplex& simplex, Vertex q) {
  const auto coefficients = barycentric_coordinates(points, simplex, points[q]);
  assert(coefficients.has_value());
  std::vector<Rational> row(points.size(), Rational(0));
  row[static_cast<std::size_t>(q)] = 1;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    row[static_cast<std::size_t>(simplex[i])] = -(*coefficients)[i];
  }
  return row;
}

bool is_vertex(const Triangulation& triangulation, Vertex v) {
  for (const Simplex& simplex : triangulation.simplices()) {
    if (contains(simplex, v)) return true;
  }
  return false;
}

// One row for each interior facet and for each point that is no vertex.
RationalMatrix heights_that_must_be_positive(const PointSet& points,
                                             const Triangulation& triangulation) {
  RationalMatrix rows;
  for (const auto& [facet, apexes] : apexes_by_facet(triangulation)) {
    if (apexes.size() != 2) continue;
    Simplex simplex = facet;
    simplex.push_back(apexes[0]);
    rows.push_back(height_above(points, simplex, apexes[1]));
  }
  for (Vertex q = 0; points.names(q); ++q) {
    if (is_vertex(triangulation, q)) continue;
    for (const Simplex& simplex : triangulation.simplices()) {
      const auto coefficients = barycentric_coordinates(points, simplex, points[q]);
      if (!coefficients || !is_convex(*coefficients)) continue;
      rows.push_back(height_above(points, simplex, q));
      break;
    }
  }
  return rows;
}

}  // namespace

// Heights may be taken ≥ 0, since adding a constant to all changes nothing, and as low as possible.
std::optional<std::vector<Rational>> heights_of_regular(const PointSet& points,
                                                        const Triangulation& triangulation) {
  LinearProgram program;
  program.equations = heights_that_must_be_positive(points, triangulation);
  program.objective.assign(points.size(), Rational(-1));
  program.objective.resize(points.size() + program.equations.size(), Rational(0));
  program.right_sides.assign(program.equations.size(), Rational(1));
  for (std::size_t row = 0; row < program.equations.size(); ++row) {
    program.equations[row].resize(program.objective.size(), Rational(0));
    program.equations[row][points.size() + row] = -1;
  }
  LinearProgramAnswer answer = maximize(program);
  if (answer.status == LinearProgramStatus::kInfeasible) return std::nullopt;
  answer.solution.resize(points.size());
  return answer.solution;
}

}  // namespace circumspect::optimality
