// The canonical perturbation: the weights of the points, made generic symbolically.
// Book: Section 2.9 (weight perturbations), Section 4.2 ("the least-vertex triangulation is
// consistent with the weight perturbations"), Section 5.6 (why gift-wrapping needs it).
#pragma once

#include <span>

#include "kernel/predicates/configuration.hpp"

namespace circumspect {

// in_ball under the canonical perturbation: order the points lexicographically by their
// coordinates, v_1 < v_2 < …, and give v_i the additional weight ω_i, ω_1 ≫ ω_2 ≫ … > 0 all
// infinitesimal.
//
// The amount by which q⁺ lies below the witness plane of the simplex is Σ_j λ_j h_j − h_q, with λ
// the barycentric coordinates of q and h the heights. A weight lowers its point by ω, so the
// perturbation adds ω_q − Σ_j λ_j ω_j. If the unperturbed amount is zero, the point that comes
// first in lexicographic order decides, unless its coefficient vanishes: +1 if it is q, −λ_j if it
// is vertex j.
//
// Laws (held by perturbation_test.cpp under these numbers):
//  P1 it is never zero for a non-degenerate simplex and q not among its vertices.
//  P2 it equals in_ball wherever that is not zero.
//  P3 it depends on coordinates alone: renumbering the points renumbers the answers.
//  P4 translation and positive uniform scaling keep it.
//  P5 no permutation of the simplex changes it.
//  P6 it equals in_ball of the points with actual weights ω_i = ε^i for all small enough ε.
//  P7 law B5 holds for it.
// Requires: as in_ball; q not a vertex of the simplex.
int perturbed_in_ball(const Configuration& points, std::span<const std::size_t> axes,
                      std::span<const Vertex> simplex, Vertex q);

// Within the affine hull of all points. Requires: simplex.size() == points.dimension() + 1.
int perturbed_in_ball(const Configuration& points, std::span<const Vertex> simplex, Vertex q);

// The conflict test of a ghost simplex. `facet` is a hull facet, a (k−1)-simplex in a set of
// dimension k, and `outward` the sign that orientation(facet…, x) has for points x on its outer
// side. Positive iff q lies in the outer halfspace of the facet: strictly beyond it, or coplanar
// with it and in its own (perturbed) open circumdisk. Never zero. Book: Section 5.2 ("Call the
// union of these two regions the outer halfspace of vwx").
// Requires: facet.size() == points.dimension(), not degenerate; q not among its vertices.
int perturbed_in_outer_halfspace(const Configuration& points, std::span<const Vertex> facet,
                                 int outward, Vertex q);

}  // namespace circumspect
