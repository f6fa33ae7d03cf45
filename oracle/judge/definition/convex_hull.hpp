// Is a list of facets the boundary of a convex hull? The definition of the claim `convex-hull`: the
// facets are simplices of dimension k − 1, where k is that of the points' affine hull, they form a
// complex (complex.hpp), and their union is the boundary of conv S. Book: Section 4.2.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect::definition {

// All require facets of k points of the set that are affinely independent, and k ≥ 1.

// Two points strictly on either side of a facet's hyperplane: the first on each side, in order of
// indices. None if the hyperplane supports conv S. That decides whether the facet is in the
// boundary: a convex part of the boundary has a supporting hyperplane that holds all of it.
std::optional<Simplex> on_both_sides(const PointSet& points, const Simplex& facet);

// Do the facets cover the boundary of conv S? They do if, for each facet of conv S, those in it
// have the hull of its points for their union (triangulation.hpp).
// Requires: they form a complex, and each is in the boundary.
bool cover_boundary(const PointSet& points, const std::vector<Simplex>& facets);

// The points in the boundary of conv S, ascending: those of a facet of conv S.
std::vector<Vertex> boundary_points(const PointSet& points);

// Is v no convex combination of the other points?
bool is_extreme(const PointSet& points, Vertex v);

}  // namespace circumspect::definition
