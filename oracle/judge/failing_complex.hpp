// A fast way to say what is wrong with a mesh of doubles that is not a complex.
#pragma once

#include <optional>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/complex_demands.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// The verdict of judge_complex, word for word: the fast engine finds which simplices have to be
// left out for the others to form a complex, and exact checkers look at these and at all that they
// may meet. Nothing if it cannot find out, or if the demands ask for more of a mesh that is
// not a complex.
// Instances: as of fast::simplex_facts.
template <std::size_t kDimension, typename Index>
std::optional<Verdict> failing_complex(const fast::MeshView<kDimension, Index>& mesh,
                                       const ComplexDemands& demands, std::size_t max_violations,
                                       unsigned threads);

}  // namespace circumspect::check
