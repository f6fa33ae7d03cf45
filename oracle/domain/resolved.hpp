// Untidy input made tidy: where cells meet there is a vertex.
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

struct ResolvedInput {
  PiecewiseLinearInput input;
  std::vector<Vertex> labels;  // of its vertices
  std::size_t added = 0;       // vertices where cells meet, numbered after all others
  std::size_t merged = 0;      // vertices that were equal to an earlier one
};

// The arrangement (kernel/piecewise_linear/arrangement.hpp) of an input whose vertices somebody has
// labelled. A vertex keeps its label; of equal ones that of the first counts.
ResolvedInput resolved(const PiecewiseLinearInput& input, const std::vector<Vertex>& labels);

}  // namespace circumspect
