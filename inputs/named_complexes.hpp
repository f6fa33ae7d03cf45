// Piecewise linear complexes that have a name.
#pragma once

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::generators {

// The axis-parallel box with corners (low, low, low) and (high, high, high): 8 vertices in binary
// order of their coordinates (x lowest), 6 square polygons.
PiecewiseLinearInput box(const Rational& low, const Rational& high);

// Schönhardt's polyhedron: vertices 0 1 2 below, 3 4 5 above and turned; 8 triangles; the edges 0
// 4, 1 5 and 2 3 are reflex. It has no triangulation. Book: Figure 4.10.
PiecewiseLinearInput schonhardt();

// A twisted prism like Schönhardt's, with an apex 6 below its floor 0 1 2 which is open, so that
// the apex sees all of it; all seven vertices on a sphere. Every triangulation of it is a CDT. With
// the floor as a further polygon (`with_floor`), Schönhardt's prism is closed and there is no
// triangulation. Book: Exercise 5 of Chapter 5.
PiecewiseLinearInput prism_on_a_sphere(bool with_floor);

// A cube of side 4 with three segments inside that pass each other at distance 1/2, one along each
// axis, their ends isolated vertices in the faces. It has no triangulation, but has one if a
// segment is left out (`without` names it: 0, 1 or 2). Book: Figure 4.12.
PiecewiseLinearInput cube_with_three_segments(int without = -1);

// A double pyramid over the triangle 0 1 2 with apexes 3 and 4, and the segment 3 4 inside. Its
// only triangulation, of three tetrahedra, is not constrained Delaunay. Book: Figure 4.15.
PiecewiseLinearInput encircled_segment();

// Chazelle's polyhedron: a box with `notches` wedges cut out of its floor, parallel to one side,
// and as many out of its ceiling, parallel to the other; the sharp edges of the former lie on the
// hyperbolic paraboloid z = xy, those of the latter just above. Every convex part of it meets few
// of the places where such edges pass each other. Book: Figure 4.13. Requires: notches ≥ 1.
PiecewiseLinearInput chazelle(int notches);

// Two inputs as one; the vertices of the second are numbered after those of the first.
PiecewiseLinearInput both(PiecewiseLinearInput first, const PiecewiseLinearInput& second);

}  // namespace circumspect::generators
