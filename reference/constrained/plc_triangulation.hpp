// A triangulation of a piecewise linear complex. Book: Definitions 4.4, 4.5 and 4.7.
#pragma once

#include <vector>

#include "reference/complex/simplex.hpp"

namespace circumspect::constrained {

// The simplices of a triangulation that are faces of no other, each with its vertices ascending, in
// lexicographic order, so that two triangulations are the same complex iff they compare equal.
struct PlcTriangulation {
  std::vector<Simplex> simplices;  // the d-simplices: tetrahedra in space, triangles in the plane
  // Dangling: triangles (in space) and edges that are a face of no simplex of higher dimension, and
  // isolated vertices.
  std::vector<Simplex> dangling;

  bool operator==(const PlcTriangulation&) const = default;
};

}  // namespace circumspect::constrained
