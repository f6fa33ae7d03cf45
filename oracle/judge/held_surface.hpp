// A fast way to see that triangles in space, given by doubles, are a complex, or which do not fit.
#pragma once

#include <optional>

#include "oracle/judge/complex/findings.hpp"
#include "oracle/model/complex_demands.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// The verdict of judge_complex on triangles that hold, if that is seen quickly; else nothing, and
// judge_complex decides.
std::optional<Verdict> held_surface(const Mesh& mesh, const ComplexDemands& demands,
                                    std::size_t max_violations);

// Tells judge_complex of a mesh that does not hold which triangles in space are the reason. Empty
// if the points are not doubles in space. Requires: the mesh outlives it.
ImproperAmong improper_of_surface(const Mesh& mesh);

}  // namespace circumspect::check
