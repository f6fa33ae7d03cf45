// Parts of lattices: periodic sets, whose Delaunay subdivisions repeat one degenerate cell or a few (Book:
// Section 4.2). As in point_sets.hpp: distinct points, as many as `count` says.
#pragma once

#include <cstddef>
#include <vector>

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// Z^d: cubes with 2^d cospherical corners. Body-centred: with the cubes' centres, where the cells in
// space are tetrahedra, though four meet in an edge. Face-centred (D_d, the integer points of even sum):
// octahedra and tetrahedra. All within 3 of the origin.
std::vector<Point> cubic_lattice_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> body_centred_lattice_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> face_centred_lattice_points(Dice& dice, std::size_t dimension, Count count);

// Hexagonal layers, one above the other: equilateral triangles as near as doubles come, for √3 is
// irrational; points that should be cocircular are so up to rounding. Requires: dimension >= 2.
std::vector<Point> hexagonal_lattice_points(Dice& dice, std::size_t dimension, Count count);

}  // namespace circumspect::generators
