// Turns a user's arrays into a mesh, and names of claims into claims.
#pragma once

#include <string>

#include <circumspect/subject.hpp>

#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::arrays {

// Claims by their names.

// One of the claims that need no domain. Throws std::invalid_argument for any other name.
Claim claim_named(const std::string& claim);

// From arrays to a mesh that can be judged.

// The mesh of these points, in the memory of their array, which has to outlive it, with weights if
// they count; labels are the places in the array. Throws std::invalid_argument: coordinates that
// are not a multiple of the dimension or not finite; a number of weights other than that of the
// points, or weights that are not finite.
Mesh mesh_of(const PointArray& points, const SimplexArray& simplices, bool weighted = false);
Mesh mesh_of(PointArray&& points, const SimplexArray& simplices, bool weighted = false) = delete;

// The same in exact numbers. The first of equal points represents all (if weights count, the one
// with the largest weight, below which the others are submerged), and simplices that name another
// of them name it.
ExactMesh exact_mesh_of(const PointArray& points, const SimplexArray& simplices,
                        bool weighted = false);

}  // namespace circumspect::arrays
