// Has a simplex of lower dimension an empty circumball? Book: Section 4.1 (Delaunay simplices of
// any dimension).
#pragma once

#include <functional>
#include <vector>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"

namespace circumspect::check {

// Some or all of the vertices in a closed ball; at least one strictly inside, if there is any.
using VerticesNear = std::function<std::vector<Vertex>(const Ball&)>;

// A few vertices such that every open circumball of the simplex contains one of them; none iff some
// open circumball contains no vertex at all. The circumballs of a j-simplex have their centres on a
// flat of dimension d − j, and each vertex cuts off a halfspace of it: a linear program in the
// centre, to which vertices are added only when the centre found so far is too near to one.
// Requires: the simplex affinely independent, of dimension d − 1 or 1, in the plane or in space.
std::vector<Vertex> vertices_in_every_circumball(const PointSet& points, const Simplex& simplex,
                                                 const VerticesNear& near);

}  // namespace circumspect::check
