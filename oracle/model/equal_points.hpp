// Points of a mesh that are equal: which, and how they are made one.
#pragma once

#include <vector>

#include "oracle/model/mesh.hpp"

namespace circumspect {

// Every point that repeats an earlier one, in order of `again`. On doubles, by sorting indices.
std::vector<Duplicate> equal_points(const Mesh& mesh);

// Makes equal points one: the first of them, or the heaviest (of these the first) if they have weights,
// since the others are submerged below it. It stands where the first stood, and keeps its own index and
// its weight. Simplices and faces that name another of them name that one instead, and Mesh::as_listed
// knows what they named. Returns what equal_points said.
// Requires: nothing has been merged before.
std::vector<Duplicate> merge_equal_points(Mesh& mesh);

}  // namespace circumspect
