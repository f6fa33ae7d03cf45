// Conflicts between simplices of a triangulation with ghosts and vertices yet to insert.
// Book: Sections 5.2 (ghost tetrahedra) and 5.4 (conflicts).
#pragma once

#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::delaunay {

// Does q lie in the (perturbed) open circumball of the simplex or, if it is a ghost, in the outer
// halfspace of its solid facet? Requires: the simplex positively oriented, q not its vertex.
bool is_in_conflict(const PointSet& points, const Simplex& simplex, Vertex q);

// The same without the perturbation: a point on the sphere, or in the facet's plane on its
// circumsphere, is not in conflict. Book: Chapter 5, Exercise 3 (Del S beside Del S[ω]).
bool is_in_unperturbed_conflict(const PointSet& points, const Simplex& simplex, Vertex q);

using ConflictTest = bool (*)(const PointSet& points, const Simplex& simplex, Vertex q);

}  // namespace circumspect::delaunay
