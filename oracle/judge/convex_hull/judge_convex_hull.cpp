#include "oracle/judge/convex_hull/judge_convex_hull.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>

#include "kernel/complex/by_facet.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/complex/adjacency.hpp"
#include "oracle/judge/complex/improper_pairs.hpp"
#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/convex_hull/star_conditions.hpp"
#include "oracle/judge/definition/convex_hull.hpp"

namespace circumspect::check {
namespace {

// The vertices of a hull in the plane in their cyclic order, if there is one a row.
std::optional<Simplex> cycle_of(const ExactMesh& mesh) {
  const std::vector<Simplex>& rows = mesh.simplices;
  const auto is_one = [](const Simplex& row) { return row.size() == 1; };
  const bool may_be = mesh.points.dimension() == 2 && rows.size() >= 3;
  if (!may_be || !std::all_of(rows.begin(), rows.end(), is_one)) return std::nullopt;
  Simplex cycle;
  for (const Simplex& row : rows) cycle.push_back(row[0]);
  return cycle;
}

std::vector<Simplex> edges_of(const Simplex& cycle) {
  std::vector<Simplex> edges;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    edges.push_back({cycle[i], cycle[(i + 1) % cycle.size()]});
  }
  return edges;
}

class HullJudge {
 public:
  HullJudge(const PointSet& points, definition::ListedComplex listed, bool by_definition,
            Verdict& verdict)
      : points_(points),
        listed_(std::move(listed)),
        by_definition_(by_definition),
        verdict_(verdict) {}

  void judge(const HullDemands& demands, bool oriented) {
    const auto size = static_cast<std::size_t>(points_.dimension());
    const ComplexDemands of_complex{.oriented =
                                        oriented ? Orientations::kSame : Orientations::kAny};
    Findings found;
    found.apart = by_definition_ ? definition::set_apart(listed_, size)
                                 : sorted_apart(listed_, points_.configuration(), size);
    const bool are_sound = found.apart.compared.size() == listed_.simplices.size();
    std::optional<HeldHull> held;
    if (are_sound && !by_definition_) held = held_hull(points_, listed_.simplices);
    if (are_sound && oriented) find_orientations(found);
    if (are_sound && !held) find_pairs(found);
    add_findings(listed_, found, of_complex, size, verdict_);
    if (!are_sound) return;
    if (!held) {
      judge_boundary(found);
      assert(by_definition_ || !verdict_.holds());
    }
    if (verdict_.holds()) judge_demands(demands, held ? &*held : nullptr);
  }

 private:
  void find_orientations(Findings& found) const {
    found.inconsistent =
        by_definition_ ? definition::inconsistent_facets(listed_.simplices)
                       : inconsistent_facets(listed_.simplices, facet_uses(listed_.simplices));
  }

  void find_pairs(Findings& found) const {
    if (by_definition_) {
      found.improper = definition::improper_pairs(listed_, found.apart);
      return;
    }
    std::vector<std::size_t> all(listed_.simplices.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    found.improper = improper_pairs(points_.configuration(), listed_, found.apart, all);
  }

  // Of facets that do not meet as they should, or are not in the boundary, nobody asks what they
  // leave uncovered.
  void judge_boundary(const Findings& found) {
    bool are_in_boundary = true;
    for (std::size_t f = 0; f < listed_.simplices.size(); ++f) {
      const auto two = definition::on_both_sides(points_, listed_.simplices[f]);
      if (two) add_not_supporting(f, *two);
      are_in_boundary = are_in_boundary && !two;
    }
    const definition::ImproperPairs& pairs = found.improper;
    const bool is_complex =
        pairs.overlaps.empty() && pairs.hanging.empty() && pairs.crossing.empty();
    if (!is_complex || !are_in_boundary) return;
    const std::vector<FacetUse> uses = facet_uses(listed_.simplices);
    const bool is_covered = by_definition_
                                ? definition::cover_boundary(points_, listed_.simplices)
                                : !listed_.simplices.empty() && open_facets(uses).empty();
    if (is_covered) return;
    if (listed_.simplices.empty()) verdict_.add(Rule::kHullUncovered, {});
    for (const auto group : ByFacet(uses)) {
      if (group.size() != 1) continue;
      verdict_.add(Rule::kHullUncovered,
                   {.simplices = {listed_.simplices[group[0].simplex]}, .face = group[0].facet});
    }
  }

  void add_not_supporting(std::size_t facet, const Simplex& two) {
    Witness witness{.simplices = {listed_.simplices[facet]}, .vertices = two};
    for (const Vertex q : two) {
      const Simplex joined = with_apex(listed_.simplices[facet], q);
      const Configuration& points = points_.configuration();
      witness.values.push_back({q == two[0] ? "orientation determinant of the facet and the first"
                                            : "orientation determinant of the facet and the second",
                                orientation_determinant(points, points.axes(), joined)});
    }
    verdict_.add(Rule::kFacetNotSupporting, witness);
  }

  void judge_demands(const HullDemands& demands, const HeldHull* held) {
    if (demands.all_boundary_points) {
      for (const Vertex v : held != nullptr ? held->beside : beside_by_definition()) {
        verdict_.add(Rule::kBoundaryPointLeftOut, {.vertices = {v}});
      }
    }
    if (!demands.only_extreme) return;
    for (const Vertex v :
         held != nullptr ? not_extreme(points_, listed_.simplices) : not_extreme_by_definition()) {
      verdict_.add(Rule::kVertexNotExtreme, {.vertices = {v}});
    }
  }

  bool is_vertex(Vertex v) const {
    return std::any_of(listed_.simplices.begin(), listed_.simplices.end(),
                       [v](const Simplex& facet) { return contains(facet, v); });
  }

  std::vector<Vertex> beside_by_definition() const {
    std::vector<Vertex> found = definition::boundary_points(points_);
    std::erase_if(found, [this](Vertex v) { return is_vertex(v); });
    return found;
  }

  std::vector<Vertex> not_extreme_by_definition() const {
    std::vector<Vertex> found;
    for (Vertex v = 0; points_.names(v); ++v) {
      if (is_vertex(v) && !definition::is_extreme(points_, v)) found.push_back(v);
    }
    return found;
  }

  const PointSet& points_;
  definition::ListedComplex listed_;
  bool by_definition_;
  Verdict& verdict_;
};

}  // namespace

std::string fault_of_hull(const Mesh& mesh) {
  if (mesh.points() < 2) {
    return "expected at least two points for the claim convex-hull, found " +
           std::to_string(mesh.points()) + ": one point has no boundary";
  }
  const std::size_t size = mesh.simplices.columns();
  const std::size_t full = mesh.dimension() + 1;
  if (size != full) return "";
  return "expected the facets of a hull, each of " + std::to_string(full - 1) +
         " vertices, found simplices of " + std::to_string(size) +
         " vertices: list the boundary alone, or ask --claim triangulation of the mesh";
}

Verdict judge_convex_hull(const ExactMesh& mesh, const HullDemands& demands, bool oriented,
                          bool by_definition, std::size_t max_violations) {
  Verdict verdict(Claim::kConvexHull, mesh, max_violations);
  definition::ListedComplex listed{mesh.points.points(), mesh.simplices};
  const std::optional<Simplex> cycle = cycle_of(mesh);
  if (cycle) listed.simplices = edges_of(*cycle);
  verdict.simplices = listed.simplices.size();
  HullJudge(mesh.points, std::move(listed), by_definition, verdict).judge(demands, oriented);
  return verdict;
}

}  // namespace circumspect::check
