#include "reference/complex/oriented_facet.hpp"

#include <utility>

namespace circumspect {

OrientedFacet OrientedFacet::of(const Simplex& vertices_in_order) {
  return {sorted(vertices_in_order), is_odd_permutation(vertices_in_order)};
}

OrientedFacet OrientedFacet::opposite(const Simplex& simplex, std::size_t place) {
  OrientedFacet facet = of(facet_opposite(simplex, place));
  // Bringing the apex to the end takes one transposition for each vertex behind it.
  const bool moves_are_odd = (simplex.size() - 1 - place) % 2 == 1;
  facet.reversed ^= moves_are_odd;
  return facet;
}

Simplex join(const OrientedFacet& facet, Vertex apex) {
  Simplex simplex = facet.vertices;
  simplex.push_back(apex);
  if (facet.reversed) std::swap(simplex[simplex.size() - 1], simplex[simplex.size() - 2]);
  return simplex;
}

}  // namespace circumspect
