// The flip algorithm. Book: Section 4.4, and Section 2.5 for the plane.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::delaunay {

// How the algorithm decides whether a facet is locally Delaunay. Perturbed tests aim at the
// canonical triangulation. Unperturbed ones call a facet between cospherical simplices locally
// Delaunay, whichever way it cuts: the algorithm may then stop at a Delaunay triangulation that is
// not the canonical one, or get stuck; there is no guarantee even after the insertion of one
// vertex.
enum class FlipTest { kPerturbed, kUnperturbed };

// The reason for a flip: a vertex to insert, or a facet that was not locally Delaunay; neither for
// the simplex that insertion starts with.
struct FlipStep {
  const ExtendedFlip& flip;
  std::optional<Vertex> vertex = {};
  std::optional<Simplex> facet = {};
};
using FlipWatch = std::function<void(const FlipStep&)>;  // is called after each flip

// A facet that is not locally Delaunay, and the simplices without which it cannot be flipped.
struct BlockedFacet {
  Simplex facet;
  std::vector<Simplex> missing;
};

// The result of a run of flips. It is stuck if facets remain that are not locally Delaunay, all of
// them blocked.
struct FlipRun {
  std::size_t flips = 0;
  std::vector<BlockedFacet> blocked;  // ascending facets

  bool is_stuck() const { return !blocked.empty(); }
};

// Is the facet locally Delaunay: is it on the hull, or is the apex on one side of it not inside the
// open circumball of the simplex on the other side? Book: Section 4.2.
// Requires: the facet is in the triangulation.
bool is_locally_delaunay(const PointSet& points, const StarIndex& triangulation,
                         const Simplex& facet, FlipTest test);

// Flips facets that are not locally Delaunay, as long as there is one whose flip is not blocked.
// Looks first at the given facets, then at those that appear. Requires: all other facets of the
// triangulation are locally Delaunay.
FlipRun flip_until_done(const PointSet& points, StarIndex& triangulation,
                        std::vector<Simplex> facets, FlipTest test = FlipTest::kPerturbed,
                        const FlipWatch& watch = {});

struct FlippedTriangulation {
  Triangulation triangulation;
  FlipRun run;
};

// The flip algorithm, from any triangulation of the points. If it does not get stuck, all facets of
// the result are locally Delaunay, and it is the (weighted: with points that may have been flipped
// out) Delaunay triangulation. Flips of facets never insert a vertex: if the `start` of a weighted
// set leaves points out, the result is the weighted Delaunay triangulation of its vertices alone.
// Unweighted sets of dimension 1 and 2 never get stuck (Proposition 2.5). Requires: `start` covers
// the convex hull of the set.
FlippedTriangulation flip_algorithm(const PointSet& points, const Triangulation& start,
                                    FlipTest test = FlipTest::kPerturbed);

// No run of the flip algorithm over n points in d dimensions takes more flips than this, whether it
// gets stuck or not: 2 Σ C(n, i) over i from 1 to 1 + ⌊d/2⌋, which is O(n^(1+⌊d/2⌋)).
// Book: Section 4.4 ("a flip can be modeled as the act of gluing a (d+1)-simplex to the underside
// of the lifted triangulation"). So what a flip covers is never visible from below again: each
// simplex of any dimension appears at most once and disappears at most once. And in each flip, of
// the two parts of its affine dependence, one appears and the other disappears; the smaller one has
// at most 1 + ⌊d/2⌋ vertices.
Integer most_flips(std::size_t n, std::size_t d);

}  // namespace circumspect::delaunay
