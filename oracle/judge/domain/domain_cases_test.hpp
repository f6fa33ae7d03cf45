// For tests: meshes and domains, exact facts about them, and verdicts as text.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include <doctest/doctest.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// All that a verdict says, as text, so that two can be compared in a test. What people read is made
// of the same.

inline void write_vertices(std::ostream& out, const Simplex& simplex) {
  for (const Vertex v : simplex) out << " " << v;
}
inline void write_point(std::ostream& out, const Point& point) {
  for (const Rational& x : point) out << " " << x;
}

inline void write_witness(std::ostream& out, const Witness& witness) {
  for (const Simplex& simplex : witness.simplices) {
    out << " simplex";
    write_vertices(out, simplex);
  }
  out << " face";
  write_vertices(out, witness.face.value_or(Simplex{}));
  out << " vertices";
  write_vertices(out, witness.vertices);
  for (const NamedValue& value : witness.values) out << " " << value.name << " " << value.value;
  if (witness.ball) {
    out << " ball";
    write_point(out, witness.ball->centre);
    out << " " << witness.ball->squared_radius;
  }
  if (witness.point) {
    out << " point";
    write_point(out, *witness.point);
  }
  if (witness.domain_cell) {
    out << " cell";
    write_vertices(out, *witness.domain_cell);
  }
  if (witness.polygon) out << " polygon " << *witness.polygon;
  if (witness.nearest) {
    out << " nearest " << witness.nearest->vertex << " " << witness.nearest->squared_distance;
  }
}

inline std::string text_of(const Verdict& verdict) {
  std::ostringstream out;
  const auto word = [](const std::optional<bool>& fact) { return fact ? (*fact ? 1 : 0) : -1; };
  out << name(verdict.claim()) << (verdict.holds() ? " holds " : " fails ") << verdict.points << " "
      << verdict.simplices << " " << verdict.dimension << " unique " << word(verdict.unique)
      << " canonical " << word(verdict.canonical) << "\n";
  if (verdict.steiner_points) {
    out << verdict.steiner_points->on_segments << " " << verdict.steiner_points->in_polygons << " "
        << verdict.steiner_points->in_polyhedra << " Steiner points\n";
  }
  if (verdict.holds()) out << verdict.dangling << " dangling\n";
  if (verdict.extra_vertices) {
    out << verdict.extra_vertices->count << " extra:";
    write_vertices(out, verdict.extra_vertices->first);
    out << "\n";
  }
  for (const auto& [rule, tally] : verdict.tallies()) {
    out << identifier(rule) << " " << tally.count;
    if (tally.worst_margin) out << " worst " << *tally.worst_margin;
    out << "\n";
  }
  for (const Violation& violation : verdict.violations()) {
    out << identifier(violation.rule);
    write_witness(out, violation.witness);
    out << "\n";
  }
  return out.str();
}

// What is known of the simplices of a mesh, by exact numbers and by looking at everything: what a
// faster judge has to find, for tests.

inline bool fills_hull(const ExactMesh& mesh) {
  Verdict verdict(Claim::kTriangulation, mesh, 1);
  judge_vertex_set(mesh, verdict);
  return judge_complex_by_lemma(mesh, facet_uses(mesh.simplices), verdict) && verdict.holds();
}

// Nothing if conditions 0 and 1 do not hold of the simplices.
inline std::optional<fast::SimplexFacts> exact_facts(Claim claim, const ExactMesh& mesh,
                                                     const Domain& domain) {
  const PointSet& points = mesh.points;
  if (mesh.simplices.empty()) return std::nullopt;
  if (points.dimension() != static_cast<int>(points.ambient_dimension())) return std::nullopt;
  const std::vector<FacetUse> uses = facet_uses(mesh.simplices);
  Verdict verdict(claim, mesh, 1);
  if (!judge_simplices(mesh, false, verdict)) return std::nullopt;
  if (!judge_facet_matching(mesh, uses, verdict)) return std::nullopt;
  fast::SimplexFacts known;
  for (const auto group : ByFacet(uses)) {
    const Simplex& simplex = mesh.simplices[group[0].simplex];
    const fast::FacetId facet(group[0].simplex, group[0].opposite);
    if (group.size() == 1) known.boundary.push_back(facet);
    if (group.size() == 1 || !is_about_balls(claim)) continue;
    const Configuration& all = points.configuration();
    const Vertex apex = mesh.simplices[group[1].simplex][group[1].opposite];
    const int side = in_ball(all, simplex, apex);
    if (side > 0) known.not_local.push_back(facet);
    if (side != 0) continue;
    known.ties.push_back(facet);
    const bool canonical = perturbed_in_ball(all, all.axes(), simplex, apex) < 0;
    if (!canonical) known.not_canonical.push_back(facet);
  }
  for (auto* facets : {&known.boundary, &known.not_local, &known.ties, &known.not_canonical}) {
    std::sort(facets->begin(), facets->end());
  }
  known.fills_hull = domain.complex.kind == DomainKind::kHull && fills_hull(mesh);
  if (claim != Claim::kConformingDelaunay) return known;
  known.doubtful_balls.emplace();
  for (const fast::FacetId facet : known.boundary) {
    const std::size_t s = facet.simplex();
    for (Vertex v = 0; points.names(v); ++v) {
      const Simplex& simplex = mesh.simplices[s];
      if (contains(simplex, v) || in_ball(points.configuration(), simplex, v) <= 0) continue;
      known.doubtful_balls->push_back(s);
      break;
    }
  }
  return known;
}

inline Domain domain_of(const PiecewiseLinearInput& input) { return {assemble(input)}; }

// The domain whose polygons are some facets of a mesh.
inline Domain domain_of_facets(const ExactMesh& mesh,
                               const std::function<bool(std::size_t)>& takes) {
  PiecewiseLinearInput input;
  std::map<Vertex, Vertex> vertex_of;
  for (const auto group : ByFacet(facet_uses(mesh.simplices))) {
    if (!takes(group.size())) continue;
    Simplex polygon = group.front().facet;
    for (Vertex& v : polygon) {
      const auto [found, is_new] = vertex_of.try_emplace(v, vertex_of.size());
      if (is_new) input.points.push_back(mesh.points[v]);
      v = found->second;
    }
    input.polygons.push_back({{polygon}, {}});
  }
  auto complex = validated(input);
  REQUIRE(complex.has_value());
  return {std::move(*complex)};
}

// The verdict by lemma: the same word for word whether anything is known of the simplices or not.
inline Verdict verdict_by_lemma(Claim claim, const ExactMesh& mesh, const Domain& domain) {
  const Verdict verdict = judge_domain(claim, mesh, domain);
  const std::optional<fast::SimplexFacts> known = exact_facts(claim, mesh, domain);
  if (known) CHECK(text_of(judge_domain(claim, mesh, domain, {}, &*known)) == text_of(verdict));
  return verdict;
}

inline std::set<Rule> broken(Claim claim, const ExactMesh& mesh, const Domain& domain,
                             By by = By::kLemma) {
  std::set<Rule> rules;
  const Verdict verdict = by == By::kLemma ? verdict_by_lemma(claim, mesh, domain)
                                           : judge_exactly(claim, mesh, &domain, {.by = by});
  for (const auto& [rule, tally] : verdict.tallies()) rules.insert(rule);
  return rules;
}

inline bool holds(Claim claim, const ExactMesh& mesh, const Domain& domain, By by) {
  return judge_exactly(claim, mesh, &domain, {.by = by}).holds();
}

// The rules broken by lemma, where by definition the claim fails too.
inline std::set<Rule> rules(const ExactMesh& mesh, const Domain& domain,
                            Claim claim = Claim::kSteinerTriangulation) {
  CHECK(!holds(claim, mesh, domain, By::kDefinition));
  return broken(claim, mesh, domain);
}

inline void check_holds(Claim claim, const ExactMesh& mesh, const Domain& domain) {
  CHECK(broken(claim, mesh, domain, By::kLemma) == std::set<Rule>{});
  CHECK(broken(claim, mesh, domain, By::kDefinition) == std::set<Rule>{});
}

// A unit cube's vertices are numbered by the bits of their coordinates, x lowest.
inline const std::vector<Simplex> kCubeInFive = {
    {0, 3, 5, 6}, {0, 1, 3, 5}, {0, 2, 3, 6}, {0, 4, 5, 6}, {3, 5, 6, 7}};
inline const std::vector<Simplex> kCubeInSix = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7},
                                                {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

// The cells of a grid, each cut along the diagonal from its least corner to its greatest: six
// tetrahedra, or with one z two triangles in the plane. Only those whose least corner (by its three
// places) is kept; and only the points that these have.
using KeepCell = std::function<bool(std::size_t i, std::size_t j, std::size_t k)>;
inline ExactMesh grid(const std::vector<int>& xs, const std::vector<int>& ys,
                      const std::vector<int>& zs, const KeepCell& keep) {
  const bool flat = zs.size() == 1;
  std::map<Point, Vertex> number;
  std::vector<Point> points;
  const auto vertex = [&](std::array<std::size_t, 3> at) {
    Point point = {xs[at[0]], ys[at[1]]};
    if (!flat) point.push_back(zs[at[2]]);
    const auto [found, is_new] = number.insert({point, static_cast<Vertex>(points.size())});
    if (is_new) points.push_back(point);
    return found->second;
  };
  std::vector<Simplex> simplices;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      for (std::size_t k = 0; flat ? k < 1 : k + 1 < zs.size(); ++k) {
        if (!keep(i, j, k)) continue;
        std::vector<std::size_t> steps = {0, 1};
        if (!flat) steps.push_back(2);
        do {
          std::array<std::size_t, 3> at = {i, j, k};
          Simplex simplex = {vertex(at)};
          for (const std::size_t step : steps) {
            ++at[step];
            simplex.push_back(vertex(at));
          }
          simplices.push_back(simplex);
        } while (std::next_permutation(steps.begin(), steps.end()));
      }
    }
  }
  return {PointSet(points), simplices};
}
inline bool every_cell(std::size_t, std::size_t, std::size_t) { return true; }

// The grid of eight unit cubes without a tetrahedron at its centre, (1, 1, 1), that has no facet in
// a face of the whole; one of its facets has no vertex off these.
inline ExactMesh eight_cubes_with_a_gap() {
  ExactMesh mesh = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  const std::vector<Point> gap = {{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 1}};
  std::erase_if(mesh.simplices,
                [&](const Simplex& simplex) { return coordinates(mesh.points, simplex) == gap; });
  return mesh;
}

// An axis-parallel box, or in the plane (one z) a rectangle.
inline PiecewiseLinearInput cuboid(const Point& low, const Point& high) {
  PiecewiseLinearInput input;
  if (low.size() == 2) {
    input.points = {low, {high[0], low[1]}, high, {low[0], high[1]}};
    input.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
    return input;
  }
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Point point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.push_back((corner >> axis) % 2 == 0 ? low[axis] : high[axis]);
    }
    input.points.push_back(point);
  }
  for (const auto& line : std::vector<std::vector<Vertex>>{
           {0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
    input.polygons.push_back({{line}, {}});
  }
  return input;
}

}  // namespace circumspect::check
