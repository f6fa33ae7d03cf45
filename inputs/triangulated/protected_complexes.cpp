#include "inputs/triangulated/protected_complexes.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"
#include "inputs/triangulated/merged_facets.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/simplex_predicates.hpp"

namespace circumspect::properties {
namespace {

using generators::add_if_valid;
using generators::Cells;
using generators::ComplexCase;
using generators::Dice;
using generators::polygon_along;

// Some of the items, in random order.
template <typename T>
std::vector<T> pick_some(Dice& dice, std::size_t count, std::vector<T> from) {
  std::vector<T> picked;
  while (picked.size() < count && !from.empty()) {
    const auto place = from.begin() + static_cast<std::ptrdiff_t>(dice.below(from.size()));
    picked.push_back(*place);
    *place = from.back();
    from.pop_back();
  }
  return picked;
}

// The edges that a complex may use, and the simplices and polygons that can be made of them.
class ProtectedEdges {
 public:
  ProtectedEdges(const PointSet& points, Protection protection) : points_(points) {
    const Triangulation triangulation = delaunay::bowyer_watson(points);
    for (const Simplex& facet : facets_of(triangulation.simplices())) facets_.insert(facet);
    for (const Simplex& simplex : triangulation.simplices()) {
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        for (std::size_t j = i + 1; j < simplex.size(); ++j)
          edges_.insert({simplex[i], simplex[j]});
      }
    }
    if (protection == Protection::kCanonical) return;
    std::erase_if(
        edges_, [&](const Simplex& edge) { return !delaunay::is_strongly_delaunay(points, edge); });
  }

  std::vector<Simplex> all() const { return {edges_.begin(), edges_.end()}; }
  bool join(Vertex v, Vertex w) const { return edges_.contains(sorted({v, w})); }

  bool has_facet(const Simplex& triangle) const { return facets_.contains(triangle); }

  // The affinely independent triples and quadruples of vertices that are joined pairwise.
  std::vector<Simplex> cliques(std::size_t size) const {
    std::vector<Simplex> found = all();
    while (!found.empty() && found.front().size() < size) {
      std::vector<Simplex> larger;
      for (const Simplex& clique : found) {
        for (Vertex v = clique.back() + 1; points_.names(v); ++v) {
          if (!std::all_of(clique.begin(), clique.end(), [&](Vertex w) { return join(w, v); }))
            continue;
          Simplex with_v = clique;
          with_v.push_back(v);
          if (flat_through(points_, with_v).dimension() == clique.size()) larger.push_back(with_v);
        }
      }
      found = std::move(larger);
    }
    return found;
  }

  // Closed lines of four edges in a plane, each beginning at its least vertex.
  std::vector<std::vector<Vertex>> quadrilaterals() const {
    std::vector<std::vector<Vertex>> found;
    for (const Simplex& diagonal : pairs()) {
      std::vector<Vertex> common;
      for (Vertex v = diagonal[0] + 1; points_.names(v); ++v) {
        if (join(diagonal[0], v) && join(diagonal[1], v)) common.push_back(v);
      }
      for (std::size_t i = 0; i < common.size(); ++i) {
        for (std::size_t j = i + 1; j < common.size(); ++j) {
          const std::vector<Vertex> line = {diagonal[0], common[i], diagonal[1], common[j]};
          if (flat_through(points_, line).dimension() == 2) found.push_back(line);
        }
      }
    }
    return found;
  }

 private:
  std::vector<Simplex> pairs() const {
    std::vector<Simplex> all;
    for (Vertex v = 0; points_.names(v); ++v) {
      for (Vertex w = v + 1; points_.names(w); ++w) all.push_back({v, w});
    }
    return all;
  }

  const PointSet& points_;
  std::set<Simplex> edges_, facets_;
};

void add_polygons(Dice& dice, PiecewiseLinearInput& input, const ProtectedEdges& edges,
                  std::size_t tries) {
  std::vector<Simplex> triangles = edges.cliques(3);
  if (dice.below(3) > 0) {
    std::erase_if(triangles, [&](const Simplex& triangle) { return edges.has_facet(triangle); });
  }
  for (const Simplex& triangle : pick_some(dice, tries, triangles)) {
    add_if_valid(input, {{}, {polygon_along(triangle)}});
  }
  for (const auto& line : pick_some(dice, dice.below(tries + 1), edges.quadrilaterals())) {
    add_if_valid(input, {{}, {polygon_along(line)}});
  }
}
void add_segments(Dice& dice, PiecewiseLinearInput& input, const ProtectedEdges& edges,
                  std::size_t tries) {
  for (const Simplex& edge : pick_some(dice, tries, edges.all())) add_if_valid(input, {{edge}, {}});
}

// The unchanged polygons, or some coplanar ones that share edges merged into one. Those whose union
// would make the complex invalid remain separate.
std::vector<PolygonLines> merged_at_random(Dice& dice, const PiecewiseLinearInput& input,
                                           const std::vector<Simplex>& facets) {
  std::vector<PolygonLines> polygons;
  if (dice.below(3) == 0) {
    for (const Simplex& facet : facets) polygons.push_back(polygon_along(facet));
    return polygons;
  }
  const PointSet points(input.points);
  for (const std::vector<Simplex>& part : coplanar_parts(points, facets)) {
    if (part.size() > 1 && dice.below(5) > 0) {
      polygons.push_back(polygon_of(points, part));
    } else {
      for (const Simplex& facet : part) polygons.push_back(polygon_along(facet));
    }
  }
  return polygons;
}

// A union of tetrahedra that is connected through facets; every other time, all of them.
std::set<Simplex> grown(Dice& dice, const Triangulation& triangulation) {
  const std::vector<Simplex>& all = triangulation.simplices();
  if (dice.below(2) == 0) return {all.begin(), all.end()};
  const StarIndex index(all);
  std::set<Simplex> chosen = {all[dice.below(all.size())]};
  for (std::size_t i = dice.below(2 * all.size()); i > 0; --i) {
    const Simplex& from =
        *std::next(chosen.begin(), static_cast<std::ptrdiff_t>(dice.below(chosen.size())));
    const std::vector<Simplex> star = index.star(facet_opposite(from, dice.below(4)));
    chosen.insert(star.begin(), star.end());
  }
  return chosen;
}

// A point in each of the cavities: components of the complement of the chosen tetrahedra that do
// not reach the hull. Each only every other time.
std::vector<Point> cavity_seeds(Dice& dice, const PointSet& points,
                                const Triangulation& triangulation,
                                const std::set<Simplex>& chosen) {
  std::vector<Point> seeds;
  const StarIndex index(triangulation.simplices());
  std::set<Simplex> seen = chosen;
  for (const Simplex& first : triangulation.simplices()) {
    if (!seen.insert(first).second) continue;
    std::vector<Simplex> pending = {first};
    bool reaches_hull = false;
    while (!pending.empty()) {
      const Simplex simplex = pending.back();
      pending.pop_back();
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        const std::vector<Simplex> star = index.star(facet_opposite(simplex, i));
        reaches_hull = reaches_hull || star.size() == 1;
        for (const Simplex& next : star) {
          if (seen.insert(next).second) pending.push_back(next);
        }
      }
    }
    if (reaches_hull || dice.below(2) == 0) continue;
    seeds.push_back(barycentre(points, first));
  }
  return seeds;
}

}  // namespace

ComplexCase protected_polygons(Dice& dice, std::vector<Point> vertices, Protection protection) {
  ComplexCase made{"protected polygons", {std::move(vertices), {}, {}, {}, DomainKind::kHull}};
  const PointSet points(made.input.points);
  const ProtectedEdges edges(points, protection);
  add_polygons(dice, made.input, edges, 1 + dice.below(10));
  add_segments(dice, made.input, edges, dice.below(6));
  return made;
}

ComplexCase protected_solid(Dice& dice, std::vector<Point> vertices, Protection protection) {
  ComplexCase made{"protected solid", {std::move(vertices), {}, {}, {}, DomainKind::kEnclosed}};
  PiecewiseLinearInput& input = made.input;
  const PointSet points(input.points);
  const ProtectedEdges edges(points, protection);
  std::set<Simplex> facets;
  for (const Simplex& tetrahedron : pick_some(dice, 1 + dice.below(8), edges.cliques(4))) {
    Cells cells;
    std::set<Simplex> added;
    for (std::size_t i = 0; i < 4; ++i) {
      const Simplex facet = facet_opposite(tetrahedron, i);
      if (facets.contains(facet)) continue;
      cells.polygons.push_back(polygon_along(facet));
      added.insert(facet);
    }
    if (add_if_valid(input, cells)) facets.merge(added);
  }
  PiecewiseLinearInput merged = input;
  merged.polygons = merged_at_random(dice, input, {facets.begin(), facets.end()});
  if (validated(merged, 1)) input = merged;
  add_polygons(dice, input, edges, dice.below(4));
  add_segments(dice, input, edges, dice.below(4));
  return made;
}

ComplexCase delaunay_polyhedron(Dice& dice, std::vector<Point> vertices) {
  ComplexCase made{"Delaunay polyhedron", {std::move(vertices), {}, {}, {}, DomainKind::kEnclosed}};
  PiecewiseLinearInput& input = made.input;
  const PointSet points(input.points);
  if (points.dimension() < 3) return made;
  const Triangulation triangulation = delaunay::bowyer_watson(points);
  const std::set<Simplex> chosen = grown(dice, triangulation);
  const StarIndex index({chosen.begin(), chosen.end()});
  std::vector<Simplex> boundary = facets_of({chosen.begin(), chosen.end()});
  std::erase_if(boundary, [&](const Simplex& facet) { return index.star(facet).size() == 2; });
  input.polygons = merged_at_random(dice, input, boundary);
  input.hole_seeds = cavity_seeds(dice, points, triangulation, chosen);
  return made;
}

}  // namespace circumspect::properties
