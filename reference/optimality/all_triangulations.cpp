#include "reference/optimality/all_triangulations.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <set>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "reference/optimality/criteria.hpp"

namespace circumspect::optimality {

std::vector<Simplex> simplicial_complex(const Triangulation& triangulation) {
  const auto by_dimension = [](const Simplex& a, const Simplex& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  };
  std::set<Simplex, decltype(by_dimension)> all(by_dimension);
  for (const Simplex& simplex : triangulation.simplices()) {
    for (const Simplex& face : faces(simplex)) all.insert(face);
  }
  return {all.begin(), all.end()};
}

namespace {

// The position of a point with respect to a closed simplex of full dimension.
struct Location {
  bool is_inside = true;
  bool is_on_some_facet_hyperplane = false;
};

Location locate(const PointSet& points, const Simplex& simplex, Vertex q) {
  Location location;
  for (const int sign : barycentric_signs(points.configuration(), simplex, q)) {
    if (sign == 0) location.is_on_some_facet_hyperplane = true;
    if (sign < 0) location.is_inside = false;
  }
  return location;
}

// The simplices that a triangulation may consist of: all that are not degenerate and, if all points
// must be vertices, contain no point except their own vertices.
std::vector<Simplex> eligible_simplices(const PointSet& points, VertexUse use) {
  std::vector<Simplex> eligible;
  Simplex subset = first_subset(static_cast<std::size_t>(points.dimension()) + 1);
  do {
    if (orientation(points.configuration(), subset) == 0) continue;
    bool holds_another = false;
    for (Vertex q = 0; points.names(q); ++q) {
      if (!contains(subset, q) && locate(points, subset, q).is_inside) holds_another = true;
    }
    if (use == VertexUse::kSomePoints || !holds_another) eligible.push_back(subset);
  } while (next_subset(subset, points.size()));
  return eligible;
}

// The points and, last, one more of conv S that is on no hyperplane through a facet of the
// simplices: in every triangulation exactly one simplex contains it. The combinations Σ m^i p_i,
// scaled, are on any one hyperplane only for the roots m of a polynomial.
PointSet with_a_point_in_general_position(const PointSet& points,
                                          const std::vector<Simplex>& simplices) {
  for (long m = 1;; ++m) {
    Point sum(points.ambient_dimension(), Rational(0));
    Rational total = 0;
    Rational power = 1;
    for (const Point& p : points.points()) {
      sum = sum + power * p;
      total += power;
      power *= m;
    }
    std::vector<Point> all = points.points();
    const Point o = (1 / total) * sum;
    if (std::find(all.begin(), all.end(), o) != all.end()) continue;
    all.push_back(o);
    PointSet extended(std::move(all));
    const auto last = static_cast<Vertex>(points.size());
    if (std::none_of(simplices.begin(), simplices.end(), [&](const Simplex& simplex) {
          return locate(extended, simplex, last).is_on_some_facet_hyperplane;
        })) {
      return extended;
    }
  }
}

// Puts one simplex after another against an uncovered side of a facet. Which facet is next depends
// on the simplices so far alone, and in a given triangulation only one simplex covers it: so every
// triangulation is met exactly once.
class ExhaustiveSearch {
 public:
  ExhaustiveSearch(const PointSet& points, VertexUse use)
      : points_(points),
        simplices_(eligible_simplices(points, use)),
        proper_(simplices_.size() * simplices_.size()) {
    for (std::size_t i = 0; i < simplices_.size(); ++i) {
      for (const OrientedFacet& covered : sides(simplices_[i])) covering_[covered].push_back(i);
    }
  }

  std::vector<Triangulation> run() {
    const PointSet extended = with_a_point_in_general_position(points_, simplices_);
    const auto o = static_cast<Vertex>(points_.size());
    for (std::size_t i = 0; i < simplices_.size(); ++i) {
      if (locate(extended, simplices_[i], o).is_inside) add(i, {});
    }
    return std::move(found_);
  }

 private:
  std::vector<OrientedFacet> sides(const Simplex& simplex) const {
    std::vector<OrientedFacet> all;
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const Simplex facet = facet_opposite(simplex, place);
      all.push_back({facet, side_of(facet, simplex[place]) < 0});
    }
    return all;
  }

  int side_of(const Simplex& facet, Vertex q) const {
    return side_of_facet(points_.configuration(), facet, q);
  }

  // Does the convex hull of the points extend beyond this side of a facet?
  bool has_points_beyond(const OrientedFacet& one) {
    const auto [entry, is_new] = has_points_beyond_.try_emplace(one, false);
    for (Vertex q = 0; is_new && points_.names(q) && !entry->second; ++q) {
      entry->second = side_of(one.vertices, q) == one.front();
    }
    return entry->second;
  }

  bool meet_properly(std::size_t a, std::size_t b) {
    std::optional<bool>& known = proper_[a * simplices_.size() + b];
    if (!known) known = !improper_intersection(points_, simplices_[a], simplices_[b]);
    return *known;
  }

  // Adds a simplex to those chosen, continues, and removes it again.
  void add(std::size_t simplex, std::set<OrientedFacet> uncovered) {
    for (const OrientedFacet& covered : sides(simplices_[simplex])) {
      const OrientedFacet other = covered.reverse();
      if (uncovered.erase(covered) == 0 && has_points_beyond(other)) uncovered.insert(other);
    }
    chosen_.push_back(simplex);
    if (uncovered.empty()) {
      record();
    } else {
      const auto candidates = covering_.find(*uncovered.begin());
      if (candidates != covering_.end()) {
        for (const std::size_t next : candidates->second) {
          if (std::all_of(chosen_.begin(), chosen_.end(),
                          [&](std::size_t one) { return meet_properly(one, next); })) {
            add(next, uncovered);
          }
        }
      }
    }
    chosen_.pop_back();
  }

  // No side of a facet within the hull is uncovered: the simplices fill conv S. If all points are
  // to be vertices they are, since no simplex contains another point.
  void record() {
    std::vector<Simplex> simplices;
    for (const std::size_t i : chosen_) simplices.push_back(simplices_[i]);
    found_.emplace_back(points_.dimension(), std::move(simplices));
  }

  const PointSet& points_;
  std::vector<Simplex> simplices_;
  std::map<OrientedFacet, std::vector<std::size_t>> covering_;
  std::map<OrientedFacet, bool> has_points_beyond_;
  std::vector<std::optional<bool>> proper_;
  std::vector<std::size_t> chosen_;
  std::vector<Triangulation> found_;
};

}  // namespace

std::vector<Triangulation> all_triangulations(const PointSet& points, VertexUse use) {
  if (points.empty()) return {Triangulation(-1, {})};
  if (points.dimension() == 0) return {Triangulation(0, {{0}})};
  std::vector<Triangulation> all = ExhaustiveSearch(points, use).run();
  std::sort(all.begin(), all.end(), [](const Triangulation& a, const Triangulation& b) {
    return a.simplices() < b.simplices();
  });
  return all;
}

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

// One row for each interior facet and for each point that is not a vertex.
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
