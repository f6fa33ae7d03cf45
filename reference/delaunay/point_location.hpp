// Point location: by looking at every simplex (Book: Section 5.2), by walking (Section 5.5). By the
// conflict graph: conflict_graph.hpp.
#pragma once

#include <optional>

#include "reference/delaunay/statistics.hpp"
#include "reference/kernel/complex/dictionary.hpp"
#include "reference/kernel/complex/point_set.hpp"

namespace circumspect::delaunay {

// Some simplex of the dictionary, solid or ghost, in conflict with q; nothing if there is none,
// because q is submerged. Requires: q is not a vertex of the dictionary's simplices.
std::optional<Simplex> linear_scan(const PointSet& points, const SimplexDictionary& dictionary,
                                   Vertex q, Statistics& statistics);

// Walks from a solid simplex to one in conflict with q: the solid simplex that contains q or, if q
// lies outside the triangulation, the ghost simplex through whose facet the walk would leave.
// Nothing if q is submerged: the simplex that contains it is not in conflict with it.
//
// The book traces a straight line. This walk leaves each simplex through any facet that has the
// simplex behind it and q strictly in front, so that no line can meet an edge and need a choice.
//
// It ends in every canonical Delaunay triangulation, weighted or not: the (perturbed) lower hull is
// strictly convex, so where a walk crosses a facet towards q the witness plane of the next simplex
// passes strictly higher over q than that of the one before, and no simplex comes twice.
//
// Where it ends, the simplex is in conflict with q or q is submerged: the witness plane of a
// simplex that contains q carries the lower hull over q, and q⁺ is below it or not. (Without
// weights q⁺ is below it, as q is in the open circumball of every simplex that contains it.) A point
// strictly in front of a hull facet is in conflict with its ghost, whatever the weights.
//
// Requires: the dictionary holds the canonical triangulation of some points, with its ghosts; q is
// not one of its vertices; `start` is one of its solid simplices, positively oriented.
std::optional<Simplex> walk(const PointSet& points, const SimplexDictionary& dictionary,
                            const Simplex& start, Vertex q, Statistics& statistics);

}  // namespace circumspect::delaunay
