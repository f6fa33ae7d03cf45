// From the doubles that a program takes to the exact points that judge it, and right answers to begin
// with.
#pragma once

#include <circumspect/subject.hpp>

#include "reference/kernel/complex/point_set.hpp"

namespace circumspect::faulty {

// The exact points, weights included. Requires: no duplicates.
PointSet exact_points(const PointArray& points);

// The canonical (weighted) Delaunay triangulation. Of points that coincide, the first stands for all.
SimplexArray right_answer(const PointArray& points);

// The same points without, or with only, some of them.
PointArray selection(const PointArray& points, const std::vector<Vertex>& kept);

// The simplices of a selection, in the numbers of the whole.
SimplexArray renumbered(SimplexArray simplices, const std::vector<Vertex>& kept);

// All indices of the points, ascending.
std::vector<Vertex> every_index(const PointArray& points);

}  // namespace circumspect::faulty
