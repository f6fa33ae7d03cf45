// Conflicts, and the search for a simplex that is in conflict with a point. Book: Sections 5.2,
// 5.4 and 5.5.
#pragma once

#include <cstdint>
#include <optional>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "reference/delaunay/dictionary.hpp"

namespace circumspect::delaunay {

// Statistics of an incremental insertion. Book: Sections 5.2, 5.4 and 5.5.

// The simplices of the start count as created. "The total running time of the algorithm is
// proportional to the number of tetrahedra created plus the number of conflicts created" (proof of
// Theorem 5.4); for walking, steps replace conflicts.
struct Statistics {
  std::uint64_t solid_simplices_created = 0;
  std::uint64_t ghost_simplices_created = 0;
  std::uint64_t solid_simplices_deleted = 0;
  std::uint64_t ghost_simplices_deleted = 0;
  // How often the conflict graph filed a vertex with a simplex.
  std::uint64_t conflicts_created = 0;
  // How often a walk went from one simplex to the next.
  std::uint64_t walk_steps = 0;
  // The number of conflict tests between a vertex and a simplex, by any caller.
  std::uint64_t conflict_tests = 0;

  bool operator==(const Statistics&) const = default;
};

// Conflicts between simplices of a triangulation with ghosts and vertices yet to insert.
// Book: Sections 5.2 (ghost tetrahedra) and 5.4 (conflicts).

// Does q lie in the (perturbed) open circumball of the simplex or, if it is a ghost, in the outer
// halfspace of its solid facet? Requires: the simplex positively oriented, q not its vertex.
bool is_in_conflict(const PointSet& points, const Simplex& simplex, Vertex q);

// The same without the perturbation: a point on the sphere, or in the facet's plane on its
// circumsphere, is not in conflict. Book: Chapter 5, Exercise 3 (Del S beside Del S[ω]).
bool is_in_unperturbed_conflict(const PointSet& points, const Simplex& simplex, Vertex q);

using ConflictTest = bool (*)(const PointSet& points, const Simplex& simplex, Vertex q);

// Point location: by looking at every simplex (Book: Section 5.2), by walking (Section 5.5). By the
// conflict graph: conflict_graph.hpp.

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
// weights q⁺ is below it, as q is in the open circumball of every simplex that contains it.) A
// point strictly in front of a hull facet is in conflict with its ghost, whatever the weights.
//
// Requires: the dictionary holds the canonical triangulation of some points, with its ghosts; q is
// not one of its vertices; `start` is one of its solid simplices, positively oriented.
std::optional<Simplex> walk(const PointSet& points, const SimplexDictionary& dictionary,
                            const Simplex& start, Vertex q, Statistics& statistics);

}  // namespace circumspect::delaunay
