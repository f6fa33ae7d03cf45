// Bistellar flips, the flip algorithm, and insertion by flips. Book: Section 4.4.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// ---- Flip ----
// Bistellar flips in any dimension. Book: Section 4.4, Figures 4.6 and 4.7.

// A basic flip of dimension j: the two triangulations of j+2 points of a j-flat, no j+1 of which
// lie in a flat of lower dimension. There are no others. Simplices are ascending, in lexicographic
// order.
//
// Why two: those points have one affine dependence (up to a factor), which divides them into the
// points with a positive and those with a negative coefficient; the convex hulls of the two parts
// meet in one point (Radon). A triangulation has one part as a face, and then consists of the
// simplices that omit one point of the other part, or the other way round. For any heights, one of
// the two is the lower and one the upper side of the lifted points, the W-simplex of the book.
struct BasicFlip {
  std::vector<Simplex> deleted;  // T_D
  std::vector<Simplex> created;  // T_C

  BasicFlip reverse() const { return {created, deleted}; }
};

// The flip among the k+2 points W = simplex ∪ {apex} that deletes the simplex; or if some vertices
// of W take no part in the affine dependence (the W-simplex has vertical facets, whatever the
// heights), the flip of dimension j < k that deletes a face of the simplex.
// - Apex beyond a facet f of the simplex: removes f, and the simplex f * apex too.
// - Apex inside the simplex: inserts it. The j-face that holds it is divided into j+1 j-simplices.
// Requires: the simplex is a k-simplex, k the dimension of the set; the apex is not its vertex.
BasicFlip basic_flip(const PointSet& points, const Simplex& simplex, Vertex apex);

// The effect of a basic flip on a triangulation: it exchanges T_D * Z for T_C * Z, where Z is the
// set of the (k−j−1)-simplices that join T_D to the rest. For a flip with j = k, Z holds only the
// empty simplex.
struct ExtendedFlip {
  std::vector<Simplex> deleted;  // T_D * Z
  std::vector<Simplex> created;  // T_C * Z

  // "2-3" and so on: the numbers of simplices deleted and created.
  std::string name() const;
};

// The members of T_D * Z that the triangulation lacks; never empty.
struct BlockedFlip {
  std::vector<Simplex> missing;
};

// The flip in a triangulation T, or what blocks it. A suitable Z must hold every ζ such that τ * ζ
// is in T for some τ in T_D, because T_D * Z has to contain every simplex of T with a face in T_D;
// and no other, because T_D * Z has to be part of T. So Z is the union of the links of T_D, and the
// flip is possible iff these are all equal. Requires: at least one simplex of T_D is a face of T.
tl::expected<ExtendedFlip, BlockedFlip> extended_flip(const StarIndex& triangulation,
                                                      const BasicFlip& flip);

// The flip that removes a facet: W are the vertices of the two simplices that share it. Whether the
// facet is locally Delaunay plays no part.
// Requires: the facet is in the triangulation, and not on the hull.
BasicFlip flip_of_facet(const PointSet& points, const StarIndex& triangulation,
                        const Simplex& facet);

// The procedure of Figure 4.8, FLIP(T, uvw), for tetrahedra: performs the flip that removes the
// triangle uvw. Where the book assumes that uvw can be flipped, a blocked flip changes nothing and
// returns what is missing. Does the same as extended_flip(T, flip_of_facet(points, T, uvw)), which
// serves any dimension.
// Requires: points.dimension() == 3; uvw is in the triangulation, and not on the hull.
tl::expected<ExtendedFlip, BlockedFlip> flip(const PointSet& points, StarIndex& triangulation,
                                             Vertex u, Vertex v, Vertex w);

// ---- Flip algorithm ----
// The flip algorithm. Book: Section 4.4, and Section 2.5 for the plane.

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

// ---- Flip insertion ----
// Insertion of vertices by flips. Book: Section 4.4, last paragraph.

// The result of inserting one vertex.
struct VertexInsertion {
  // The dimension of the face whose relative interior held the vertex: in a simplex (k), in a facet
  // (k−1), …, on an edge (1). Nothing: outside the convex hull of the vertices so far.
  std::optional<std::size_t> dimension_of_face;
  bool is_submerged = false;  // then nothing has changed
  FlipRun run;                // the flips after the split; not stuck under perturbed tests
};

// Inserts u into the canonical triangulation of some of the points: first by a flip that splits the
// face that holds u (1-4, or a facet or edge split), or outside the hull by the cone from u over
// the hull facets that u sees strictly, then by the flip algorithm. In the canonical triangulation,
// with perturbed tests, that never gets stuck; with unperturbed ones there is no guarantee. In a
// weighted set u may be submerged, and vertices that u submerges are flipped out. Point location is
// a linear scan. Requires: the vertices span the affine hull of the points; all facets are locally
// Delaunay under the test; u is not a vertex and, if it was once flipped out, still submerged.
VertexInsertion insert_vertex_by_flips(const PointSet& points, StarIndex& triangulation, Vertex u,
                                       FlipTest test = FlipTest::kPerturbed,
                                       const FlipWatch& watch = {});

// The canonical (weighted) Delaunay triangulation: k+1 affinely independent points, then all others
// in the order of their indices. Any number of points, any dimension.
Triangulation flip_insertion(const PointSet& points, const FlipWatch& watch = {});

}  // namespace circumspect::delaunay
