// In which simplices of a triangulation do points lie? Book: Section 5.5 (walking).
#pragma once

#include <span>
#include <vector>

#include "oracle/certificate/certificate.hpp"

namespace circumspect::certificate {

// For each of the points a simplex that contains it (reference/kernel/exact/point_search.hpp). Requires:
// simplices and what is across their facets; each of the points is in one of the simplices.
std::vector<std::uint32_t> simplices_that_contain(const Certificate& certificate,
                                                  std::span<const std::size_t> points);

}  // namespace circumspect::certificate
