// Witnesses that more than one judge gives, so that all of them say the same in the same words.
#pragma once

#include <optional>

#include "oracle/model/verdict.hpp"

namespace circumspect {

// Adds that q is strictly inside the ball of a simplex (with weights: that q⁺ is strictly below its
// witness plane), with the ball and how deep q lies in it. `facet`: what else broke the rule, if
// anything. Where the witness would be dropped and the rule has been broken as badly, it is only
// counted, in integers.
void add_vertex_in_ball(const PointSet& points, Rule rule, const Simplex& simplex,
                        const std::optional<Simplex>& facet, Vertex q, Verdict& verdict);

// q lies strictly beyond a facet of the simplex, whose other vertex is the apex: two determinants
// of opposite signs.
Witness vertex_beyond_facet(const PointSet& points, const Simplex& simplex, const Simplex& facet,
                            Vertex apex, Vertex q);

}  // namespace circumspect
