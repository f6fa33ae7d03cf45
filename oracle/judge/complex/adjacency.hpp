// What facets say of a list of simplices: the answers of oracle/judge/definition/complex.hpp, in
// linear time apart from sorting.
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/judge/definition/complex.hpp"

namespace circumspect::check {

// All require simplices of one size, no two with the same vertices, and `uses` to be theirs.

std::vector<Simplex> open_facets(const std::vector<FacetUse>& uses);

// Which part each simplex is in, of those that facets connect: the place of one of its simplices.
std::vector<std::size_t> part_of_each(const std::vector<Simplex>& simplices,
                                      const std::vector<FacetUse>& uses);

std::vector<Simplex> inconsistent_facets(const std::vector<Simplex>& simplices,
                                         const std::vector<FacetUse>& uses);

// Requires: at most four vertices each.
definition::NotManifold not_manifold(const std::vector<Simplex>& simplices,
                                     const std::vector<FacetUse>& uses);

}  // namespace circumspect::check
