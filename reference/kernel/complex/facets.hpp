// Facets: with a front and a back (Book: Section 5.1, "oriented triangular face"), and which
// simplices of a list have them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "reference/kernel/complex/simplex.hpp"

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

// One simplex's use of a facet.
struct FacetUse {
  Simplex facet;         // its vertices, ascending
  std::size_t simplex;   // which simplex of the list has it for a face
  std::size_t opposite;  // the place of the vertex that the facet leaves out
};

// All uses, in order of the facets' vertices and then of the simplices: the uses of one facet stand
// together. Book: Section 4.2 ("a facet of a triangulation is a (d−1)-simplex").
std::vector<FacetUse> facet_uses(const std::vector<Simplex>& simplices);

// Calls `visit` once for each facet, with all its uses.
void for_each_facet(const std::vector<FacetUse>& uses,
                    const std::function<void(std::span<const FacetUse>)>& visit);

}  // namespace circumspect
