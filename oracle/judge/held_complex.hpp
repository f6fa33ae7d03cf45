// A fast way to see that a mesh of doubles is a complex.
#pragma once

#include <optional>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/complex_demands.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// The verdict of judge_complex on a mesh that holds, if linear time suffices to see it; else
// nothing, and judge_complex decides. The fast engine finds the boundary, and exact predicates
// decide what docs/theory/complex.md asks of it.
// Instances: as of fast::simplex_facts.
template <std::size_t kDimension, typename Index>
std::optional<Verdict> held_complex(const fast::MeshView<kDimension, Index>& mesh,
                                    const ComplexDemands& demands, std::size_t max_violations,
                                    unsigned threads);

}  // namespace circumspect::check
