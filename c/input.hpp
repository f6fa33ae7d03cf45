// From the structs of <circumspect/circumspect.h> to what is judged and built.
#pragma once

#include <vector>

#include <circumspect/circumspect.h>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::c {

inline constexpr std::int64_t kLargestDimension = 64;

// On the memory of the arrays, where these are doubles. `weighted`: the weights count. All of these refuse
// what is not as the header says.
Mesh mesh_of(const circumspect_mesh& mesh, bool weighted);

// Requires the word of a claim that is about a domain or not, as asked.
Claim claim_of(const char* text, bool has_domain);

// A valid complex, and of which kind.
Domain domain_of(const circumspect_domain& domain);

// Points by either array.
std::vector<Point> exact_points(std::int64_t count, std::int64_t dimension, const double* doubles,
                                const char* const* texts);

}  // namespace circumspect::c
