#include "reference/constrained/delete_polygon.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "reference/constrained/crossed_tetrahedra.hpp"
#include "reference/constrained/gift_wrap_cavity.hpp"
#include "reference/delaunay/flip_algorithm.hpp"

namespace circumspect::constrained {
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
