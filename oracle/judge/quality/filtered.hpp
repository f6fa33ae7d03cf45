// Which simplices of a mesh of doubles do not keep a requirement: by enclosed doubles, and exactly
// where these do not tell.
#pragma once

#include <vector>

#include "oracle/model/measure.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::quality {

// For each requirement the places of the simplices that do not keep it, ascending; those that are
// set apart (exact_measure.hpp) keep all. Requires: the measures exist for the dimension; threads
// ≥ 1.
std::vector<std::vector<std::size_t>> violators(const Mesh& mesh,
                                                const std::vector<Requirement>& requirements,
                                                unsigned threads);

}  // namespace circumspect::quality
