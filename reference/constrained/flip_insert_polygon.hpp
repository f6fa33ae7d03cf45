// Inserting a polygon into a CDT by bistellar flips. Book: Section 5.8, FlipInsertPolygon and
// Certify.
#pragma once

#include <compare>
#include <optional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::constrained {

// The time κ, with its infinitesimal part, when a facet of a triangulation with rising vertices
// ceases to be locally Delaunay (Section 2.9, and Exercise 2 of Chapter 3, for the perturbation):
// under the canonical perturbation, which gives the vertices weights ω_1 ≫ ω_2 ≫ … > 0 in
// lexicographic order of the vertices, every time is linear in them.
struct EventTime {
  Rational standard;
  // The rank of a vertex and the coefficient of its ω, which is not zero; ascending ranks.
  std::vector<std::pair<std::size_t, Rational>> infinitesimal;

  // By the standard parts; then by the first coefficient in which the times differ.
  friend std::strong_ordering operator<=>(const EventTime& a, const EventTime& b);
  friend bool operator==(const EventTime& a, const EventTime& b) { return (a <=> b) == 0; }
};

// The time at which the lifted tetrahedra σ⁺ and τ⁺ are cohyperplanar, σ = `tetrahedron` and τ its
// neighbour with the vertex `apex` beyond their common facet, if the interior of σ⁺ is below aff τ⁺
// at time ∞; nothing if it is not.
//
// With Σ_v c_v p_v = 0 = Σ_v c_v the affine dependence of the five vertices, c negative at the
// apex, the apex is below aff σ⁺ iff Σ_v c_v z_v(κ) > 0. The height z_v(κ) = |v|² − ω_v +
// κ d(v, h), where the last term only counts for the vertices right of h, makes that an affine
// function of κ, whose slope Σ c_v d(v, h) says what happens at time ∞. (If the slope is zero, all
// stays as it is at time 0, when the facet is locally Delaunay.)
//
// Its zero −(Σ c_v |v|²) / slope + Σ (c_v / slope) ω_v tells the dependence up to a factor. So two
// events have equal times iff they have the same dependence, and belong to one and the same flip:
// under the perturbation, no two flips are simultaneous.
std::optional<EventTime> event_time(const PolygonInSpace& polygon, const Simplex& tetrahedron,
                                    Vertex apex);

struct TimedFlip {
  EventTime time;
  delaunay::ExtendedFlip flip;
};

// The record of an insertion.
struct PolygonFlips {
  std::size_t vertices = 0;      // m, of the region R: the union of the crossed tetrahedra
  std::vector<TimedFlip> flips;  // as they were performed
  // How often an event was skipped for a later one, because its flip was inadmissible. Proposition
  // 5.5, by which there are fewer than m² flips, applies only if that never happens: its proof,
  // that no edge returns, needs each facet to go at the very time at which it ceases to be locally
  // weighted Delaunay.
  std::size_t held_back = 0;
};

// FlipInsertPolygon(T, f): turns the CDT of P into that of P ∪ {f}, or says why this is impossible
// and changes nothing. A polygon whose facets are all there already takes no flip.
//
// All heights are perturbed, not only those at time 0. Events are therefore never simultaneous,
// unless they belong to one flip, and their flips are admissible where P ∪ {f} has a CDT because P
// is edge-protected. Inadmissible flips are still held back, as the book demands. Requires: the CDT
// is that of a PLC P in which all vertices of the points that are in f are vertices, and P ∪ {f} is
// a valid PLC; it fills a convex hull, so that f does not leave it, which is asserted.
tl::expected<PolygonFlips, NoChange> flip_insert_polygon(const PointSet& points, EvolvingCdt& cdt,
                                                         const Polygon& polygon);

}  // namespace circumspect::constrained
