// The procedure Flip of the book, for tetrahedra. Book: Figure 4.8.
#pragma once

#include "reference/delaunay/flip.hpp"

namespace circumspect::delaunay {

// FLIP(T, uvw): performs the flip that removes the triangle uvw. Where the book assumes that uvw can
// be flipped, a blocked flip changes nothing and returns what is missing. Does the same as
// extended_flip(T, flip_of_facet(points, T, uvw)), which serves any dimension.
// Requires: points.dimension() == 3; uvw is in the triangulation, and not on the hull.
tl::expected<ExtendedFlip, BlockedFlip> flip(const PointSet& points, StarIndex& triangulation,
                                             Vertex u, Vertex v, Vertex w);

}  // namespace circumspect::delaunay
