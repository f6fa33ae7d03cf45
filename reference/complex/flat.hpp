// The affine hull of some points of a set: where a face of a polyhedral complex lives.
// Book: Section 4.1 ("if the affine hull of S is k-dimensional …").
#pragma once

#include <vector>

#include "reference/complex/point_set.hpp"

namespace circumspect {

// k+1 affinely independent points of the flat, and k axes that are a coordinate system of it.
struct Flat {
  Simplex basis;  // the first independent points in the order given
  std::vector<std::size_t> axes;

  std::size_t dimension() const { return axes.size(); }
};

// Requires: members is not empty.
Flat flat_through(const PointSet& points, const std::vector<Vertex>& members);

// The same for the members projected on some axes only.
Flat flat_through(const PointSet& points, const std::vector<std::size_t>& axes,
                  const std::vector<Vertex>& members);

// The vertices 0, 1, …, n−1.
std::vector<Vertex> all_vertices(const PointSet& points);

}  // namespace circumspect
