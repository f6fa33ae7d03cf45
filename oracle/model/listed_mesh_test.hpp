// A mesh of listed points and simplices, as a reader would make it.
#pragma once

#include <vector>

#include "oracle/model/mesh.hpp"

namespace circumspect {

// Points may be equal, unlike those of in_rows. Requires: a point.
inline Mesh listed_mesh(const std::vector<Point>& points, const std::vector<Simplex>& simplices) {
  Mesh mesh;
  mesh.coordinates = numbers_of(points, points.front().size());
  mesh.simplices = IndexLists(simplices);
  return mesh;
}

}  // namespace circumspect
