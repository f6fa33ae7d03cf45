// Turns a user's arrays into a mesh, and names of claims into claims.
#pragma once

#include <string>

#include <circumspect/subject.hpp>

#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::arrays {

// ---- Claims by name ----
// Claims by their names.

// One of the claims that need no domain. Throws std::invalid_argument for any other name.
Claim claim_named(const std::string& claim);

// ---- Meshes of arrays ----
// From arrays to a mesh that can be judged.

// The mesh of these points, on the memory of their array, which has to outlive it, with weights if they are
// to count; labels are the places in the array. Throws std::invalid_argument: coordinates that are
// not a multiple of the dimension or not finite; weights that are not as many as the points, or not
// finite.
Mesh mesh_of(const PointArray& points, const SimplexArray& simplices, bool weighted = false);
Mesh mesh_of(PointArray&& points, const SimplexArray& simplices, bool weighted = false) = delete;

// The same in exact numbers. Of equal points the first one stands for all (where weights count, that with
// the largest weight, below which the others are submerged), and simplices that name another of them name it.
ExactMesh exact_mesh_of(const PointArray& points, const SimplexArray& simplices,
                        bool weighted = false);

}  // namespace circumspect::arrays
