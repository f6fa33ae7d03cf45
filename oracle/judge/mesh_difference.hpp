// Are two meshes the same complex, up to numbering? The answer of cells.hpp for meshes in arrays.
#pragma once

#include <optional>

#include "oracle/judge/points/cells.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// On doubles, where all numbers are; else exactly. No weight counts as 0. None if two points of one
// mesh are equal.
std::optional<Difference> difference(const Mesh& a, const Mesh& b);

}  // namespace circumspect::check
