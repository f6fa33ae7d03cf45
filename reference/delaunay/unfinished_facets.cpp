#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect {

void UnfinishedFacets::adjoin(const Simplex& simplex) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
    if (facets_.erase(facet) == 0) facets_.insert(facet.reverse());
  }
}

}  // namespace circumspect
