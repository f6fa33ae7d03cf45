// Judges whether a list of facets is the boundary of the convex hull of the points. What that is,
// and why the conditions decide it: docs/theory/questions.md.
#pragma once

#include <string>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/hull_demands.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Why the mesh cannot be a list of facets, one line that says what to do; empty if it can.
std::string fault_of_hull(const Mesh& mesh);

// The answer is the same by definition and by lemma, but for the time that it takes. In the plane
// the hull may also be listed as three or more vertices in their cyclic order, one a row.
// `oriented`: facets go around their common ridge in opposite senses.
Verdict judge_convex_hull(const ExactMesh& mesh, const HullDemands& demands, bool oriented,
                          bool by_definition, std::size_t max_violations);

}  // namespace circumspect::check
