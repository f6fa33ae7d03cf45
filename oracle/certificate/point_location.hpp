// In which simplex of a triangulation does a point lie? Book: Section 5.5 (walking).
#pragma once

#include "oracle/certificate/certificate.hpp"

namespace circumspect::certificate {

// A simplex that contains the point, found by walking from `start`. Requires: simplices and what is
// across their facets; a simplex contains the point.
std::uint32_t simplex_that_contains(const Certificate& certificate, Vertex point,
                                    std::uint32_t start);

}  // namespace circumspect::certificate
