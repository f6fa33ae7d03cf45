// Is a surface intrinsically Delaunay? The definition of the claim `surface-delaunay`: in the two
// triangles at each edge, the angles opposite the edge have a sum of at most π. Bobenko and
// Springborn, Discrete Comput. Geom. 38, 2007.
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect::definition {

// An edge of two triangles, and the vertex of each that is opposite.
struct InteriorEdge {
  Simplex edge = {};  // ascending
  std::size_t first = 0, second = 0;
  Vertex of_first = 0, of_second = 0;
};

struct SurfaceEdges {
  std::vector<InteriorEdge> interior = {};  // in order of the edges
  std::size_t boundary = 0;                 // of one triangle
  std::size_t set_apart = 0;                // of more than two
};
// Requires: no triangle repeats a vertex.
SurfaceEdges surface_edges(const std::vector<Simplex>& triangles);

// Is α + β ≤ π? That is α ≤ π − β, and cosines fall from 0 to π: cos α ≥ −cos β.
// Requires: triangles that are not flat.
bool is_delaunay(const std::vector<Point>& points, const InteriorEdge& edge);

}  // namespace circumspect::definition
