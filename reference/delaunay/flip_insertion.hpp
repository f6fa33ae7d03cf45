// Insertion of vertices by flips. Book: Section 4.4, last paragraph.
#pragma once

#include <optional>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "reference/delaunay/flip_algorithm.hpp"

namespace circumspect::delaunay {

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
