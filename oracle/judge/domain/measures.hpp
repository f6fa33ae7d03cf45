// Exact lengths, areas and volumes, and points of space projected to a plane.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/configuration.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {

// Is the vertex in the plane of the triangle? Requires: points of space; three vertices that span a
// plane.
inline bool is_coplanar(const Configuration& points, const Simplex& triangle, Vertex v) {
  return orientation(points, kSpace, std::array{triangle[0], triangle[1], triangle[2], v}) == 0;
}

// Lengths, areas and volumes, exact. All are k! times the measure of a projection on k axes, so
// that within one line, plane or space they can be added and compared.

using Axes = std::vector<std::size_t>;

Rational measure(const PointSet& points, const Axes& axes, const Simplex& simplex);
Rational measure(const PointSet& points, const Axes& axes, const std::vector<Simplex>& simplices);

}  // namespace circumspect::check
