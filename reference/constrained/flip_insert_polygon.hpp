// Inserting a polygon into a CDT by bistellar flips. Book: Section 5.8, FlipInsertPolygon.
#pragma once

#include <tl/expected.hpp>

#include "reference/constrained/event_time.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::constrained {

struct TimedFlip {
  EventTime time;
  delaunay::ExtendedFlip flip;
};

// What an insertion did.
struct PolygonFlips {
  std::size_t vertices = 0;      // m, of the region R: the union of the crossed tetrahedra
  std::vector<TimedFlip> flips;  // as they were performed
  // How often an event was passed over for a later one, because its flip was inadmissible. Only where
  // that never happens does Proposition 5.5 apply, by which there are fewer than m² flips: its proof,
  // that no edge returns, needs each facet to go at the very time at which it ceases to be locally
  // weighted Delaunay.
  std::size_t held_back = 0;
};

// FlipInsertPolygon(T, f): makes the CDT of P that of P ∪ {f}, or says why it cannot be done, and
// then nothing has changed. A polygon whose facets are all there already takes no flip.
//
// All heights are perturbed, not only those at time 0. Events are therefore never simultaneous,
// unless they belong to one flip, and their flips are admissible where P ∪ {f} has a CDT because P
// is edge-protected. Inadmissible flips are held back all the same, as the book demands.
// Requires: the CDT is that of a PLC P in which all vertices of the points that are in f are
// vertices, and P ∪ {f} is a valid PLC; it fills a convex hull, so that f does not leave it, which
// is asserted.
tl::expected<PolygonFlips, NoChange> flip_insert_polygon(const PointSet& points, EvolvingCdt& cdt,
                                                         const Polygon& polygon);

}  // namespace circumspect::constrained
