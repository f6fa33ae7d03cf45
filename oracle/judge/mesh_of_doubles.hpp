// Meshes of exact numbers that are doubles, as arrays.
#pragma once

#include <optional>

#include "oracle/formats/flat_mesh.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// The same points, with the weights if they have any, counted from 0. None if a number is not a double.
std::optional<formats::FlatPoints> points_of_doubles(const PointSet& points);

// The same mesh, vertices and neighbours counted from 0. None if a number is not a double; if simplices
// differ in their number of vertices, or there are none; or if an index is below −1 or does not fit 32 bits.
std::optional<formats::FlatMesh> mesh_of_doubles(const Mesh& mesh);

}  // namespace circumspect::check
