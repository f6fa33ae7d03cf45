#include "reference/delaunay/gift_wrapping.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <set>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polytope.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "kernel/predicates/place.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::delaunay {

// ---- Finish ----

// Keeps the first candidate in front, and replaces it by any later one that lies in the open
// circumball of the facet and the one kept. The spheres through the facet are a pencil, in which
// the candidates in front have a linear order; the scan finds the first of them.
std::optional<Vertex> apex_of_facet(const PointSet& points, const std::vector<std::size_t>& axes,
                                    const OrientedFacet& facet,
                                    const std::vector<Vertex>& candidates) {
  std::optional<Vertex> kept;
  for (const Vertex q : candidates) {
    if (orientation(points.configuration(), axes, join(facet, q)) <= 0) continue;
    const bool better =
        !kept || perturbed_in_ball(points.configuration(), axes, join(facet, *kept), q) > 0;
    if (better) kept = q;
  }
  return kept;
}

// ---- Seeds ----

namespace {

// The facet with the members, all on one side of it, in front.
OrientedFacet facing(const PointSet& points, const std::vector<std::size_t>& axes,
                     const Simplex& facet, const std::vector<Vertex>& members) {
  const OrientedFacet oriented = OrientedFacet::of(facet);
  for (const Vertex q : members) {
    const int side = orientation(points.configuration(), axes, join(oriented, q));
    if (side != 0) return side > 0 ? oriented : oriented.reverse();
  }
  return oriented;
}

// A simplex of the canonical triangulation of the members in their own flat, on its boundary.
Simplex canonical_simplex(const PointSet& points, const std::vector<Vertex>& members) {
  const Flat flat = flat_through(points, members);
  if (flat.dimension() == 0) return {members.front()};
  const Simplex seed = canonical_simplex(points, some_facet(points, flat.axes, members));
  const OrientedFacet facet = facing(points, flat.axes, seed, members);
  const std::optional<Vertex> apex = apex_of_facet(points, flat.axes, facet, members);
  assert(apex.has_value());
  return sorted(join(facet, *apex));
}

}  // namespace

Simplex hull_facet_seed(const PointSet& points) {
  const std::vector<Vertex> all = all_vertices(points);
  return canonical_simplex(points, some_facet(points, flat_through(points, all).axes, all));
}

Simplex nearest_neighbour_seed(const PointSet& points) {
  Simplex seed = {0};
  while (static_cast<int>(seed.size()) < points.dimension()) {
    std::optional<Rational> least;
    Simplex best;
    for (const Vertex q : all_vertices(points)) {
      Simplex larger = seed;
      larger.push_back(q);
      if (flat_through(points, larger).dimension() < seed.size()) continue;
      const Rational squared_radius = circumball(points, larger).squared_radius;
      if (least && squared_radius >= *least) continue;
      least = squared_radius;
      best = larger;
    }
    seed = best;
  }
  return sorted(seed);
}

// ---- Gift-wrapping ----

std::vector<Simplex> gift_wrap(const PointSet& points, const std::vector<std::size_t>& axes,
                               UnfinishedFacets unfinished, const std::vector<Vertex>& candidates,
                               const FinishWatch& watch) {
  SimplexDictionary dictionary;
  while (!unfinished.empty()) {
    const OrientedFacet facet = unfinished.first();
    const std::optional<Vertex> apex = apex_of_facet(points, axes, facet, candidates);
    if (watch) watch(facet, apex);
    if (apex) {
      const Simplex simplex = join(facet, *apex);
      dictionary.add(simplex);
      unfinished.adjoin(simplex);
    } else {
      unfinished.remove(facet);  // Nothing is in front: the facet is on the hull.
    }
  }
  return dictionary.simplices();
}

Triangulation gift_wrapping(const PointSet& points, const Simplex& seed, const FinishWatch& watch) {
  const Flat flat = flat_through(points, all_vertices(points));
  UnfinishedFacets unfinished;
  unfinished.add(OrientedFacet::of(seed));
  unfinished.add(OrientedFacet::of(seed).reverse());
  return Triangulation(points.dimension(),
                       gift_wrap(points, flat.axes, unfinished, all_vertices(points), watch));
}

Triangulation gift_wrapping(const PointSet& points, const FinishWatch& watch) {
  if (points.empty()) return Triangulation(-1, {});
  if (points.dimension() == 0) return Triangulation(0, {{0}});
  return gift_wrapping(points, hull_facet_seed(points), watch);
}

// ---- Gift wrapping cells ----

namespace {

// A facet of a cell with a front: the side on which orientation(basis, x) has the sign `front`.
// The basis is a function of the facet, so that the sign means the same to both of its cells.
struct CellFacet {
  Simplex basis;
  int front;
};

int side(const PointSet& points, const std::vector<std::size_t>& axes, Simplex basis, Vertex q) {
  basis.push_back(q);
  return orientation(points.configuration(), axes, basis);
}

// The side of the facet on which the other points of a cell are.
int side_of_cell(const PointSet& points, const std::vector<std::size_t>& axes, const Simplex& basis,
                 const Face& cell) {
  for (const Vertex q : cell) {
    if (const int s = side(points, axes, basis, q); s != 0) return s;
  }
  return 0;
}

// Finish: the cell in front of a facet, among the members of a flat; empty if the facet is on the
// hull.
Face cell_in_front(const PointSet& points, const std::vector<std::size_t>& axes,
                   const CellFacet& facet, const std::vector<Vertex>& members) {
  Simplex kept;
  for (const Vertex q : members) {
    if (side(points, axes, facet.basis, q) != facet.front) continue;
    if (!kept.empty() && in_ball(points.configuration(), axes, kept, q) <= 0) continue;
    kept = facet.basis;
    kept.push_back(q);
  }
  Face cell;
  if (kept.empty()) return cell;
  for (const Vertex q : members) {
    if (in_ball(points.configuration(), axes, kept, q) == 0) cell.push_back(q);
  }
  return cell;
}

// A cell of the Delaunay subdivision of the members in their own flat, on its boundary: wrapped
// from a cell of the subdivision of a hull facet.
Face first_cell(const PointSet& points, const std::vector<Vertex>& members) {
  const Flat flat = flat_through(points, members);
  if (flat.dimension() == 0) return members;
  const Face seed = first_cell(points, some_facet(points, flat.axes, members));
  const Simplex basis = flat_through(points, seed).basis;
  const int front = side_of_cell(points, flat.axes, basis, members);
  return cell_in_front(points, flat.axes, {basis, front}, members);
}

}  // namespace

PolyhedralComplex gift_wrapping_cells(const PointSet& points) {
  const std::vector<Vertex> all = all_vertices(points);
  std::set<Face> cells;
  std::map<Face, CellFacet> unfinished;
  std::vector<std::size_t> axes;
  const auto add = [&](const Face& cell) {
    const bool is_new = cells.insert(cell).second;
    assert(is_new);
    for (const Face& facet : facets_by_wrapping(points, cell)) {
      if (unfinished.erase(facet) == 1) continue;
      const Simplex basis = flat_through(points, facet).basis;
      unfinished[facet] = {basis, -side_of_cell(points, axes, basis, cell)};
    }
  };
  if (!points.empty()) {
    axes = flat_through(points, all).axes;
    add(first_cell(points, all));
  }
  while (!unfinished.empty()) {
    const auto [facet, oriented] = *unfinished.begin();
    const Face cell = cell_in_front(points, axes, oriented, all);
    if (cell.empty()) {
      unfinished.erase(facet);  // Nothing is in front: the facet is on the hull.
    } else {
      add(cell);
    }
  }
  return PolyhedralComplex(points, points.dimension(), {cells.begin(), cells.end()},
                           facets_by_wrapping);
}

Triangulation gift_wrapping_by_cells(const PointSet& points) {
  return least_vertex_triangulation(points, gift_wrapping_cells(points));
}

// ---- Vertex deletion ----

namespace {

using Axes = std::vector<std::size_t>;

Simplex oriented(const PointSet& points, const Axes& axes, Simplex simplex) {
  const bool negative = orientation(points.configuration(), axes, simplex) < 0;
  if (negative) std::swap(simplex[0], simplex[1]);
  return simplex;
}

// The part of the triangulation that deleting v removes.
struct Star {
  std::vector<Simplex> simplices;  // positively oriented
  UnfinishedFacets link;           // its facets, v in front
  std::vector<Vertex> candidates;  // vertices of the link, then submerged points within
};

Star star_of(const PointSet& points, const Axes& axes, const std::vector<Simplex>& simplices,
             Vertex v, const std::vector<Vertex>& submerged) {
  Star star;
  std::set<Vertex> link_vertices;
  for (const Simplex& simplex : simplices) {
    if (!contains(simplex, v)) continue;
    star.simplices.push_back(oriented(points, axes, simplex));
    const Simplex& last = star.simplices.back();
    const auto place =
        static_cast<std::size_t>(std::find(last.begin(), last.end(), v) - last.begin());
    star.link.add(OrientedFacet::opposite(last, place));
    for (const Vertex u : last) {
      if (u != v) link_vertices.insert(u);
    }
  }
  star.candidates.assign(link_vertices.begin(), link_vertices.end());
  for (const Vertex q : submerged) {
    const bool within = std::any_of(
        star.simplices.begin(), star.simplices.end(),
        [&](const Simplex& simplex) { return lies_in(points.configuration(), axes, simplex, q); });
    if (within) star.candidates.push_back(q);
  }
  return star;
}

// All points of the set but v.
std::vector<Vertex> remaining_points(const Triangulation& triangulation, Vertex v,
                                     const std::vector<Vertex>& submerged) {
  std::set<Vertex> remaining(submerged.begin(), submerged.end());
  for (const Simplex& simplex : triangulation.simplices()) {
    remaining.insert(simplex.begin(), simplex.end());
  }
  remaining.erase(v);
  return {remaining.begin(), remaining.end()};
}

}  // namespace

Triangulation delete_vertex(const PointSet& points, const Triangulation& triangulation, Vertex v,
                            const std::vector<Vertex>& submerged) {
  const int k = triangulation.dimension();
  const std::vector<Vertex> remaining = remaining_points(triangulation, v, submerged);
  if (remaining.empty()) return Triangulation(-1, {});
  const Axes axes = flat_through(points, triangulation.simplices().front()).axes;
  const Star star = star_of(points, axes, triangulation.simplices(), v, submerged);
  std::vector<Simplex> simplices;
  if (static_cast<int>(flat_through(points, remaining).dimension()) < k) {
    // The triangulation is the cone of v over the triangulation of a facet of the hull.
    for (const OrientedFacet& facet : star.link.all()) simplices.push_back(facet.vertices);
    return Triangulation(k - 1, std::move(simplices));
  }
  simplices = gift_wrap(points, axes, star.link, star.candidates);
  for (const Simplex& simplex : triangulation.simplices()) {
    if (!contains(simplex, v)) simplices.push_back(simplex);
  }
  return Triangulation(k, std::move(simplices));
}

}  // namespace circumspect::delaunay
