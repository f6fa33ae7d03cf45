// Parts of lattices: periodic sets, whose Delaunay subdivisions repeat one degenerate cell or a few (Book:
// Section 4.2). As in point_sets.hpp: 0 to `max_points` distinct points, which shrink.
#pragma once

#include <cstddef>

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// Z^d: cubes with 2^d cospherical corners. Body-centred: with the cubes' centres, where the cells in
// space are tetrahedra, though four meet in an edge. Face-centred (D_d, the integer points of even sum):
// octahedra and tetrahedra. All within 3 of the origin.
PointSets cubic_lattice_points(std::size_t dimension, std::size_t max_points);
PointSets body_centred_lattice_points(std::size_t dimension, std::size_t max_points);
PointSets face_centred_lattice_points(std::size_t dimension, std::size_t max_points);

// Hexagonal layers, one above the other: equilateral triangles as near as doubles come, for √3 is
// irrational; points that should be cocircular are so up to rounding. Requires: dimension >= 2.
PointSets hexagonal_lattice_points(std::size_t dimension, std::size_t max_points);

}  // namespace circumspect::generators
