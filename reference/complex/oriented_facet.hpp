// Facets with a front and a back. Book: Section 5.1 ("oriented triangular face").
#pragma once

#include "reference/complex/simplex.hpp"

namespace circumspect {

// A facet with a front. In the plane and in space an order of the vertices says which side is the
// front; a single point (k = 1) has only one order, so the side is kept apart.
struct OrientedFacet {
  Simplex vertices;       // ascending
  bool reversed = false;  // is the front that of an odd permutation of `vertices`?

  // The face uvw of the book: the front is where x makes uvwx positively oriented.
  static OrientedFacet of(const Simplex& vertices_in_order);
  // The facet of a positively oriented simplex opposite one of its vertices, which is in front.
  static OrientedFacet opposite(const Simplex& simplex, std::size_t place);

  OrientedFacet reverse() const { return {vertices, !reversed}; }
  bool operator==(const OrientedFacet&) const = default;
};

// The simplex that joins a facet to an apex in front of it, positively oriented.
Simplex join(const OrientedFacet& facet, Vertex apex);

}  // namespace circumspect
