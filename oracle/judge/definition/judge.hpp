// The claims, each decided from the words of its definition. This file is the table of contents.
#pragma once

#include <cstddef>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// A claim about points: triangulation, delaunay, weighted-delaunay. `max_violations`: how many
// witnesses are kept; 0: all. Requires: only the last is asked of points with weights.
Verdict judge(Claim claim, const ExactMesh& mesh, std::size_t max_violations);

// A claim about a domain: plc-triangulation, steiner-triangulation, cdt, steiner-cdt,
// conforming-delaunay.
// Requires: as judge_plc_triangulation.
Verdict judge(Claim claim, const ExactMesh& mesh, const PiecewiseLinearComplex& domain,
              std::size_t max_violations);

}  // namespace circumspect::definition
