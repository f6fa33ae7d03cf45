// The witness that a point lies strictly inside a circumball (weighted: that its lifted companion
// lies strictly below a witness plane).
#pragma once

#include <optional>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Adds the violation, with the ball of `simplex` and how deep q lies in it. `facet` is the facet
// between the simplex and q, if that is what broke the rule.
void add_in_ball(const ExactMesh& mesh, Rule rule, const Simplex& simplex,
                 const std::optional<Simplex>& facet, Vertex q, Verdict& verdict);

}  // namespace circumspect::check
