// Points of which some are equal, made a set, and a mesh of them.
#pragma once

#include <vector>

#include "oracle/model/mesh.hpp"

namespace circumspect {

// The mesh with equal points as one: the first of them, or the heaviest (of these the first) if they
// have weights, since the others are submerged below it. It keeps its own index and its weight. Simplices
// and faces that name another of them name that one instead, and Mesh::as_listed knows what they named.
// Requires: points of one dimension; weights empty or one a point; `repeated` what duplicates(points)
// says; simplices and faces count the points from 0.
Mesh mesh_of_merged(std::vector<Point> points, std::vector<Rational> weights,
                    const std::vector<Duplicate>& repeated, Vertex first_index,
                    std::vector<Simplex> simplices, std::vector<Simplex> faces = {});

}  // namespace circumspect
