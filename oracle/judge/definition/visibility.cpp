#include "oracle/judge/definition/visibility.hpp"

#include <algorithm>
#include <optional>

#include "kernel/exact/linear_algebra.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::definition {
namespace {

// A function of the points of σ, linear in λ, by its values at the vertices of σ.
using Function = std::vector<Rational>;

// Σ λ_j f_j ≤ 0, or < 0.
struct Condition {
  Function f;
  bool is_strict;
};

Condition not_negative(Function f) {
  for (Rational& value : f) value = -value;
  return {std::move(f), false};
}

// Is there a λ with all λ_j > 0 that meets the conditions? What each leaves is an unknown as well:
// positive where it is strict.
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
    rows[1 + i][vertices + i] = 1;
  }
  const auto strict = static_cast<std::size_t>(weak - conditions.begin());
  return is_solvable(std::move(rows), std::move(right), vertices + strict);
}

// The shadow of a cell: where none of these functions is negative.
using Shadow = std::vector<Function>;

// With x − v = Σ c_i (t_i − v) for the corners t_i of the cell, the line from v to x meets the cell
// in a point other than x iff all c_i ≥ 0 and Σ c_i > 1. (Σ c_i = 1 with x in the relative interior
// of σ is the case of a cell that includes σ, or of none.) Nothing if v is in the plane (line) of
// the cell, or no point of σ is behind it.
std::optional<Shadow> shadow_of(const PointSet& points, const Simplex& cell,
                                const std::vector<std::size_t>& axes, Vertex v,
                                const Simplex& simplex) {
  Shadow shadow(cell.size() + 1, Function(simplex.size()));
  for (std::size_t j = 0; j < simplex.size(); ++j) {
    RationalMatrix rows;
    std::vector<Rational> right;
    for (const std::size_t axis : axes) {
      rows.emplace_back();
      for (const Vertex t : cell) rows.back().push_back(points[t][axis] - points[v][axis]);
      right.push_back(points[simplex[j]][axis] - points[v][axis]);
    }
    const auto c = solve(rows, right);
    if (!c) return std::nullopt;
    shadow.back()[j] = -1;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      shadow[i][j] = (*c)[i];
      shadow.back()[j] += (*c)[i];
    }
  }
  const Function& behind = shadow.back();
  if (std::all_of(behind.begin(), behind.end(), [](const auto& f) { return sign(f) <= 0; })) {
    return std::nullopt;
  }
  return shadow;
}

std::vector<Shadow> shadows_of(const PiecewiseLinearComplex& complex, Vertex v,
                               const Simplex& simplex) {
  const Configuration& points = complex.points.configuration();
  const std::vector<std::size_t> own_axes = axes_of(points, simplex);
  const std::vector<std::size_t> all_axes = {kSpace.begin(),
                                             kSpace.begin() + complex.ambient_dimension()};
  const auto is_in_hull = [&](Vertex w) {
    if (contains(simplex, w)) return true;
    Simplex joined = simplex;
    joined.push_back(w);
    return axes_of(points, joined).size() == own_axes.size();
  };
  std::vector<Shadow> shadows;
  const auto add = [&](const Simplex& cell, const std::vector<std::size_t>& axes) {
    if (auto shadow = shadow_of(complex.points, cell, axes, v, simplex)) {
      shadows.push_back(std::move(*shadow));
    }
  };
  for (const Polygon& polygon : complex.polygons) {
    for (const Simplex& triangle : polygon.triangles) add(triangle, all_axes);
  }
  if (simplex.size() == 4) return shadows;
  for (const Simplex& segment : complex.segments) {
    if (is_in_hull(segment[0]) && is_in_hull(segment[1])) add(segment, own_axes);
  }
  return shadows;
}

// Is there a point of σ that meets the conditions and is out of all shadows from the `next` on? Out
// of one it is where the first function is negative, or the first is not but the second, and so on.
bool can_be_out_of(const std::vector<Shadow>& shadows, std::size_t next, std::size_t vertices,
                   const std::vector<Condition>& conditions) {
  if (next == shadows.size()) return true;
  std::vector<Condition> in_shadow = conditions;
  for (const Function& f : shadows[next]) in_shadow.push_back(not_negative(f));
  if (!can_be_met(vertices, in_shadow)) {
    return can_be_out_of(shadows, next + 1, vertices, conditions);
  }
  std::vector<Condition> so_far = conditions;
  for (const Function& f : shadows[next]) {
    so_far.push_back({f, true});
    if (can_be_met(vertices, so_far) && can_be_out_of(shadows, next + 1, vertices, so_far)) {
      return true;
    }
    so_far.back() = not_negative(f);
  }
  return false;
}

}  // namespace

bool is_visible(const PiecewiseLinearComplex& complex, Vertex v, const Simplex& simplex) {
  return can_be_out_of(shadows_of(complex, v, simplex), 0, simplex.size(), {});
}

}  // namespace circumspect::definition
