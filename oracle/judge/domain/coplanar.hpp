// Points of space in a plane.
#pragma once

#include <array>
#include <cstddef>

#include "reference/kernel/predicates/configuration.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::check {

// Is the vertex in the plane of the triangle? Requires: points of space; three vertices that span a plane.
inline bool is_coplanar(const Configuration& points, const Simplex& triangle, Vertex v) {
  return orientation(points, kSpace, std::array{triangle[0], triangle[1], triangle[2], v}) == 0;
}

}  // namespace circumspect::check
