#include "oracle/judge/definition/visibility.hpp"

#include <algorithm>
#include <optional>

#include "kernel/exact/linear_algebra.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect::definition {
namespace {

// Is a function of the points of σ, linear in λ, positive, or not negative? `f`: its values at the
// vertices of σ.
struct Condition {
  std::vector<Rational> f;
  bool is_strict;  // Σ λ_j f_j > 0, not ≥ 0

  Condition operator!() const {
    Condition opposite{f, !is_strict};
    for (Rational& value : opposite.f) value = -value;
    return opposite;
  }
};

// Is there a λ with all λ_j > 0 that meets the conditions? The value of each function is an unknown
// as well, and positive where the condition is strict; so these come first.
bool can_be_met(std::size_t vertices, std::vector<Condition> conditions) {
  const auto weak = std::stable_partition(conditions.begin(), conditions.end(),
                                          [](const Condition& one) { return one.is_strict; });
  const std::size_t unknowns = vertices + conditions.size();
  RationalMatrix rows(1 + conditions.size(), std::vector<Rational>(unknowns, 0));
  std::vector<Rational> right(rows.size(), 0);
  std::fill_n(rows[0].begin(), vertices, Rational(1));
  right[0] = 1;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    std::copy(conditions[i].f.begin(), conditions[i].f.end(), rows[1 + i].begin());
    rows[1 + i][vertices + i] = -1;
  }
  const auto strict = static_cast<std::size_t>(weak - conditions.begin());
  return is_solvable(std::move(rows), std::move(right), vertices + strict);
}

// The shadow of a cell: where all of these conditions are met.
using Shadow = std::vector<Condition>;

// With x − v = Σ c_i (t_i − v) for the corners t_i of the cell, the line from v to x meets the cell
// in a point other than x iff all c_i ≥ 0 and Σ c_i > 1. (Σ c_i = 1 with x in the relative interior
// of σ is the case of a cell that includes σ, or of none.) Nothing if v is in the plane (line) of
// the cell.
std::optional<Shadow> shadow_of(const PointSet& points, const Simplex& cell,
                                const std::vector<std::size_t>& axes, Vertex v,
                                const Simplex& simplex) {
  Shadow shadow(cell.size(), {{}, false});
  Condition is_behind{{}, true};
  for (const Vertex x : simplex) {
    RationalMatrix rows;
    std::vector<Rational> right;
    for (const std::size_t axis : axes) {
      rows.emplace_back();
      for (const Vertex t : cell) rows.back().push_back(points[t][axis] - points[v][axis]);
      right.push_back(points[x][axis] - points[v][axis]);
    }
    const auto c = solve(rows, right);
    if (!c) return std::nullopt;
    is_behind.f.push_back(-1);
    for (std::size_t i = 0; i < cell.size(); ++i) {
      shadow[i].f.push_back((*c)[i]);
      is_behind.f.back() += (*c)[i];
    }
  }
  shadow.push_back(is_behind);
  return shadow;
}

// The shadows that have a point of σ in them.
std::vector<Shadow> shadows_of(const PiecewiseLinearComplex& complex, Vertex v,
                               const Simplex& simplex) {
  const Configuration& points = complex.points.configuration();
  std::vector<Shadow> shadows;
  const auto add = [&](const Simplex& cell, const std::vector<std::size_t>& axes) {
    const auto shadow = shadow_of(complex.points, cell, axes, v, simplex);
    if (shadow && can_be_met(simplex.size(), *shadow)) shadows.push_back(*shadow);
  };
  const std::size_t d = complex.ambient_dimension();
  for (const Simplex& wall : walls(complex)) add(wall, {kSpace.begin(), kSpace.begin() + d});
  if (simplex.size() > d) return shadows;
  const std::vector<std::size_t> axes = axes_of(points, simplex);
  for (const Simplex& segment : complex.segments) {
    if (is_in_hull_of(points, axes, simplex, segment[0]) &&
        is_in_hull_of(points, axes, simplex, segment[1])) {
      add(segment, axes);
    }
  }
  return shadows;
}

// Is there a point of σ that meets the conditions and is out of all shadows from the `next` on? Out
// of one it is where the first condition is not met, or the first is but not the second, and so on.
bool can_be_out_of(const std::vector<Shadow>& shadows, std::size_t next, std::size_t vertices,
                   const std::vector<Condition>& conditions) {
  if (next == shadows.size()) return true;
  std::vector<Condition> so_far = conditions;
  so_far.insert(so_far.end(), shadows[next].begin(), shadows[next].end());
  if (!can_be_met(vertices, so_far)) return can_be_out_of(shadows, next + 1, vertices, conditions);
  so_far = conditions;
  for (const Condition& one : shadows[next]) {
    so_far.push_back(!one);
    if (can_be_met(vertices, so_far) && can_be_out_of(shadows, next + 1, vertices, so_far)) {
      return true;
    }
    so_far.back() = one;
  }
  return false;
}

}  // namespace

bool is_visible(const PiecewiseLinearComplex& complex, Vertex v, const Simplex& simplex) {
  return can_be_out_of(shadows_of(complex, v, simplex), 0, simplex.size(), {});
}

}  // namespace circumspect::definition
