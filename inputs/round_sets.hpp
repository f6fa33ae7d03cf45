// Point sets on spheres, circles, cylinders and regular polytopes, exactly: where Delaunay
// subdivisions have cells that are not simplices, and where the perturbation decides (Book:
// Sections 2.9 and 4.2). As in point_sets.hpp: distinct points, as many as `count` says.
#pragma once

#include <cstddef>
#include <vector>

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// Rational points of one circle; in space and above with points of its axis too, so that any number
// of simplices share a circle. Requires: dimension >= 2.
std::vector<Point> circle_points(Dice& dice, std::size_t dimension, Count count);

// Rational points of a cylinder over a circle, its axis of dimension d − 2, in rings at integer
// heights: two rings lie on a common sphere. Requires: dimension >= 3.
std::vector<Point> cylinder_points(Dice& dice, std::size_t dimension, Count count);

// Integer points of one sphere, all of them equally likely, around an integer centre, times a power
// of two: exactly cospherical, and still so as doubles. Requires: 2 <= dimension <= 6.
std::vector<Point> pythagorean_points(Dice& dice, std::size_t dimension, Count count);

// Vertices of a regular polytope or one of its kin whose coordinates are integers, sometimes with
// its centre: simplex or half-cube, cube, cross-polytope, cuboctahedron (in dimension 4 the
// 24-cell), truncated octahedron; in space an icosahedron of golden rectangles 21 by 13, which is
// as good as regular. Requires: 2 <= dimension <= 16.
std::vector<Point> polytope_points(Dice& dice, std::size_t dimension, Count count);

// Corners of twisted prisms: points of a circle and their images under one rational turn and lift,
// all on one sphere; or those of Schönhardt's polyhedron, with its centre (Book: Figure 4.10).
// Requires: dimension == 3.
std::vector<Point> twisted_prism_points(Dice& dice, std::size_t dimension, Count count);

// Parts of lattices: periodic sets, whose Delaunay subdivisions repeat one degenerate cell or a few
// (Book: Section 4.2). As in point_sets.hpp: distinct points, as many as `count` says.

// Z^d: cubes with 2^d cospherical corners. Body-centred: with the cubes' centres, where the cells
// in space are tetrahedra, though four meet in an edge. Face-centred (D_d, the integer points of
// even sum): octahedra and tetrahedra. All within 3 of the origin.
std::vector<Point> cubic_lattice_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> body_centred_lattice_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> face_centred_lattice_points(Dice& dice, std::size_t dimension, Count count);

// Hexagonal layers, one above the other: triangles as nearly equilateral as doubles allow, because
// √3 is irrational; points that should be cocircular are so up to rounding. Requires: dimension >=
// 2.
std::vector<Point> hexagonal_lattice_points(Dice& dice, std::size_t dimension, Count count);

}  // namespace circumspect::generators
