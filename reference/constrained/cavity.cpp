#include "reference/constrained/cavity.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "reference/constrained/clear_apex.hpp"
#include "reference/constrained/crossed_tetrahedra.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/delaunay/flip_algorithm.hpp"
#include "reference/kernel/complex/facets.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::constrained {

// ---- Filling a cavity ----

namespace {

// Finish: a candidate counts if its simplex with the facet is clear of all facets of the cavity.
std::optional<Vertex> apex_in_cavity(const PointSet& points, const Cavity& cavity,
                                     const std::vector<OrientedFacet>& cavity_facets,
                                     const OrientedFacet& facet) {
  const auto is_clear = [&](const Simplex& simplex) {
    return std::none_of(cavity_facets.begin(), cavity_facets.end(),
                        [&](const OrientedFacet& other) {
                          return meets_interior(points, cavity.axes, simplex, other.vertices);
                        });
  };
  return first_clear_apex(points, cavity.axes, facet, cavity.candidates, is_clear).apex;
}

Simplex oriented(const PointSet& points, const std::vector<std::size_t>& axes, Simplex simplex) {
  const bool is_negative = orientation(points.configuration(), axes, simplex) < 0;
  if (is_negative) std::swap(simplex[0], simplex[1]);
  return simplex;
}

}  // namespace

Cavity cavity_of(const PointSet& points, const std::vector<std::size_t>& axes,
                 const std::set<Simplex>& walls, const std::vector<Simplex>& deleted) {
  Cavity cavity;
  cavity.axes = axes;
  std::vector<Simplex> positive;
  for (const Simplex& simplex : deleted) positive.push_back(oriented(points, axes, simplex));
  for_each_facet(facet_uses(positive), [&](std::span<const FacetUse> uses) {
    if (uses.size() == 2 && !walls.contains(uses.front().facet)) return;
    for (const FacetUse& use : uses) {
      cavity.facets.add(OrientedFacet::opposite(positive[use.simplex], use.opposite));
    }
  });
  const std::set<Vertex> vertices = vertices_of(deleted);
  cavity.candidates.assign(vertices.begin(), vertices.end());
  return cavity;
}

tl::expected<std::vector<Simplex>, NoChange> gift_wrap_cavity(const PointSet& points,
                                                              const Cavity& cavity) {
  const std::vector<OrientedFacet> cavity_facets = cavity.facets.all();
  UnfinishedFacets unfinished = cavity.facets;
  SimplexDictionary finished;
  while (!unfinished.empty()) {
    const OrientedFacet facet = unfinished.first();
    const auto apex = apex_in_cavity(points, cavity, cavity_facets, facet);
    if (!apex) return tl::unexpected(NoChange{WhyNoChange::kFacetUnfinished, facet.vertices});
    const Simplex simplex = join(facet, *apex);
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const OrientedFacet side = OrientedFacet::opposite(simplex, place);
      if (finished.adjacent(side)) {
        return tl::unexpected(NoChange{WhyNoChange::kSimplicesOverlap, side.vertices});
      }
    }
    finished.add(simplex);
    unfinished.adjoin(simplex);
  }
  std::vector<Simplex> simplices = finished.simplices();
  for (Simplex& simplex : simplices) simplex = sorted(std::move(simplex));
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

// ---- Inserting a polygon ----

std::optional<NoChange> insert_polygon_by_cavity(const PointSet& points, EvolvingCdt& cdt,
                                                 const Polygon& polygon) {
  for (const Simplex& segment : polygon.segments) {
    if (cdt.tetrahedra.star(segment).empty()) {
      return NoChange{WhyNoChange::kSegmentMissing, segment};
    }
  }
  const PolygonInSpace in_space(points, polygon);
  const std::set<Simplex> crossed = crossed_tetrahedra(cdt.tetrahedra, in_space);
  Change change{{crossed.begin(), crossed.end()}, {}};
  if (!crossed.empty()) {
    Cavity cavity = cavity_of(points, {0, 1, 2}, cdt.walls, change.deleted);
    for (const Simplex& facet : planar_cdt(points, polygon)) {
      if (!cdt.tetrahedra.star(facet).empty()) continue;
      cavity.facets.add(OrientedFacet::of(facet));
      cavity.facets.add(OrientedFacet::of(facet).reverse());
      change.walls_added.insert(facet);
    }
    auto created = gift_wrap_cavity(points, cavity);
    if (!created) return created.error();
    change.created = *std::move(created);
    if (const auto wrong = try_change(points, cdt, change)) return wrong;
  }
  cdt.walls.merge(facets_included_in(cdt.tetrahedra, in_space));
  return std::nullopt;
}

// ---- Deleting a polygon ----

namespace {

// Adds the tetrahedra on both sides of facets that are no walls. False if there are no new ones.
bool grow(const EvolvingCdt& cdt, const std::set<Simplex>& walls, std::set<Simplex>& cavity,
          const std::vector<Simplex>& facets) {
  const std::size_t before = cavity.size();
  for (const Simplex& facet : facets) {
    if (walls.contains(facet)) continue;
    for (const Simplex& side : cdt.tetrahedra.star(facet)) cavity.insert(side);
  }
  return cavity.size() > before;
}

std::optional<NoChange> rewrap(const PointSet& points, EvolvingCdt& cdt,
                               const std::set<Simplex>& walls, Change change) {
  auto created = gift_wrap_cavity(points, cavity_of(points, {0, 1, 2}, walls, change.deleted));
  if (!created) return created.error();
  change.created = *std::move(created);
  return try_change(points, cdt, change);
}

}  // namespace

std::optional<NoChange> delete_polygon(const PointSet& points, EvolvingCdt& cdt,
                                       const Polygon& polygon) {
  const std::set<Simplex> included =
      facets_included_in(cdt.tetrahedra, PolygonInSpace(points, polygon));
  for (const Simplex& facet : included) {
    assert(cdt.tetrahedra.star(facet).size() == 2 || is_on_hull(points, cdt, facet));
  }
  std::set<Simplex> walls;
  std::set_difference(cdt.walls.begin(), cdt.walls.end(), included.begin(), included.end(),
                      std::inserter(walls, walls.end()));
  std::vector<Simplex> bad;
  std::copy_if(included.begin(), included.end(), std::back_inserter(bad),
               [&](const Simplex& facet) {
                 return !delaunay::is_locally_delaunay(points, cdt.tetrahedra, facet,
                                                       delaunay::FlipTest::kPerturbed);
               });
  std::set<Simplex> cavity;
  grow(cdt, walls, cavity, bad);
  for (;;) {
    Change change{{cavity.begin(), cavity.end()}, {}};
    change.walls_removed = included;
    const auto wrong = rewrap(points, cdt, walls, change);
    if (!wrong) return std::nullopt;
    const bool has_grown = (wrong->why == WhyNoChange::kNotLocallyDelaunay &&
                            grow(cdt, walls, cavity, {wrong->witness})) ||
                           grow(cdt, walls, cavity, facets_of(change.deleted));
    if (!has_grown) return wrong;
  }
}

}  // namespace circumspect::constrained
