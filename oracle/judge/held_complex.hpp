// Sees at once that a mesh of doubles is a complex, where it is.
#pragma once

#include <optional>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/complex_demands.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// The verdict of judge_complex on a mesh that holds, if that is known in a time that grows with the mesh and no faster. The
// fast engine finds the boundary; what docs/theory/complex.md asks of that is asked exactly.
// Instances: as of fast::simplex_facts.
template <std::size_t kDimension, typename Index>
std::optional<Verdict> held_complex(const fast::MeshView<kDimension, Index>& mesh,
                                    const ComplexDemands& demands, std::size_t max_violations,
                                    unsigned threads);

}  // namespace circumspect::check
