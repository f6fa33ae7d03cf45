#include "reference/constrained/insert_polygon_by_cavity.hpp"

#include "reference/constrained/crossed_tetrahedra.hpp"
#include "reference/constrained/gift_wrap_cavity.hpp"
#include "reference/constrained/planar_cdt.hpp"

namespace circumspect::constrained {

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

}  // namespace circumspect::constrained
