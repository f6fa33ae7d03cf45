#include "reference/delaunay/gift_wrapping.hpp"

#include <optional>

#include "reference/delaunay/apex_of_facet.hpp"
#include "reference/delaunay/gift_wrapping_seed.hpp"

namespace circumspect::delaunay {

std::vector<Simplex> gift_wrap(const PointSet& points, const std::vector<std::size_t>& axes,
                               UnfinishedFacets unfinished, const std::vector<Vertex>& candidates) {
  SimplexDictionary dictionary;
  while (!unfinished.empty()) {
    const OrientedFacet facet = unfinished.first();
    const std::optional<Vertex> apex = apex_of_facet(points, axes, facet, candidates);
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

Triangulation gift_wrapping(const PointSet& points, const Simplex& seed) {
  const Flat flat = flat_through(points, all_vertices(points));
  UnfinishedFacets unfinished;
  unfinished.add(OrientedFacet::of(seed));
  unfinished.add(OrientedFacet::of(seed).reverse());
  return Triangulation(points.dimension(),
                       gift_wrap(points, flat.axes, unfinished, all_vertices(points)));
}

Triangulation gift_wrapping(const PointSet& points) {
  if (points.empty()) return Triangulation(-1, {});
  if (points.dimension() == 0) return Triangulation(0, {{0}});
  return gift_wrapping(points, hull_facet_seed(points));
}

}  // namespace circumspect::delaunay
