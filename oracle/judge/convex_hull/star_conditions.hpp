// Are facets the boundary of a convex hull? Asked of each ridge, and of each point, as they are
// seen from a point inside: docs/theory/questions.md.
#pragma once

#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect::check {

// What is known of a hull that is one: the points of its boundary that are not vertices, ascending.
struct HeldHull {
  std::vector<Vertex> beside = {};
};

// With a point o inside, five conditions that docs/theory/questions.md proves to be the definition:
// 1. o is on the hyperplane of no facet;
// 2. each ridge is in exactly two facets, and the hyperplane through it and o separates these;
// 3. no facet has the apex of the one across a ridge beyond it;
// 4. the ray from o through the centre of one facet meets no other;
// 5. no point is beyond the facet that the ray from o through it meets.
// None if one of them is broken.
// Requires: facets of k points each that are affinely independent, no two the same, where k ≥ 1 is
// the dimension of the set's affine hull.
std::optional<HeldHull> held_hull(const PointSet& points, const std::vector<Simplex>& facets);

// Of a hull that is one: its vertices that are not extreme points, ascending. The hyperplanes of
// the facets at a point have no other point in common if and only if it is extreme.
std::vector<Vertex> not_extreme(const PointSet& points, const std::vector<Simplex>& facets);

}  // namespace circumspect::check
