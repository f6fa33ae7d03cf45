// The facets of a list of simplices, and which simplices have them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "reference/complex/simplex.hpp"

namespace circumspect {

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
