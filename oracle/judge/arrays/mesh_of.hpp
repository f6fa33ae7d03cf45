// From arrays to what the checkers judge.
#pragma once

#include <circumspect/subject.hpp>

#include "oracle/model/mesh.hpp"

namespace circumspect::arrays {

// The mesh with every number exact. Of equal points the first one stands for all (where weights count,
// that with the largest weight, below which the others are submerged), and simplices that name another
// of them name it; labels are the places in the array. Throws std::invalid_argument: coordinates that
// are no multiple of the dimension or not finite; weights that are not as many as the points, or not
// finite.
Mesh mesh_of(const PointArray& points, const SimplexArray& simplices, bool weighted = false);

}  // namespace circumspect::arrays
