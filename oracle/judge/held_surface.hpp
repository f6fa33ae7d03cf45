// A fast way to see that triangles in space, given by doubles, are a complex.
#pragma once

#include <optional>

#include "oracle/model/complex_demands.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// The verdict of judge_complex on triangles that hold, if that is seen quickly; else nothing, and
// judge_complex decides.
std::optional<Verdict> held_surface(const Mesh& mesh, const ComplexDemands& demands,
                                    std::size_t max_violations);

}  // namespace circumspect::check
