// Random point sets, by family. Each function draws distinct points of one dimension, as many as
// `count` says, and what it draws follows from the dice alone.
#pragma once

#include <cstddef>
#include <vector>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect::generators {

// How many points a set should have, where equal ones count once: any number up to `most`, all
// equally likely, or exactly `most`.
struct Count {
  std::size_t most = 0;
  bool full = false;

  std::size_t drawn(Dice& dice) const { return full ? most : dice.below(most + 1); }
  // Requires: some <= most.
  Count less(std::size_t some) const { return {most - some, full}; }
};

// General position, mostly (Book: Section 2.9, "generic").
std::vector<Point> integer_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> rational_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> dyadic_points(Dice& dice, std::size_t dimension, Count count);

// Doubles of magnitudes from 2^-300 to 2^300 beside each other, on which floating-point filters and
// tolerances fail.
std::vector<Point> extreme_points(Dice& dice, std::size_t dimension, Count count);

// Up to three clusters of points that are a few units in the last place apart, so they are nearly
// coplanar, cospherical and equal.
std::vector<Point> clustered_points(Dice& dice, std::size_t dimension, Count count);

// Each point has its own denominator of about 900 bits, and denominators are mostly coprime, so
// such sets cannot reasonably be scaled to integers together.
std::vector<Point> unrelated_denominator_points(Dice& dice, std::size_t dimension, Count count);

// A part of the grid {0, 1, 2}^d, or of a larger one for more points than that has: cospherical,
// coplanar and collinear all at once; Delaunay subdivisions whose cells are not simplices (Book:
// Section 4.1, 4.2).
std::vector<Point> grid_points(Dice& dice, std::size_t dimension, Count count);

// Some of the corners of a cube, its centre and the centres of its facets; for more points, of
// cubes side by side.
std::vector<Point> cube_points(Dice& dice, std::size_t dimension, Count count);

// Exactly cospherical points, the reason for the perturbation (Book: Section 2.9). Rational ones by
// stereographic projection, each over its own denominator; integer ones as the images of one point
// under the symmetries of the cube. Requires: dimension >= 2.
std::vector<Point> sphere_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> integer_sphere_points(Dice& dice, std::size_t dimension, Count count);

// Points of a line, and of a plane, circles and grids among them: the affine hull has fewer
// dimensions than the space (Book: Section 4.1, "if the affine hull of S is k-dimensional"). Planes
// require: dimension >= 2.
std::vector<Point> line_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> plane_points(Dice& dice, std::size_t dimension, Count count);

// Points on two skew lines, with a unique Delaunay triangulation of quadratic size (Book: Section
// 4.1). Requires: dimension >= 3.
std::vector<Point> skew_line_points(Dice& dice, std::size_t dimension, Count count);

// Points (t, t², …, t^d): every d+1 of them affinely independent, and, in dimension 3 and above,
// every pair an edge (Book: Section 4.1, the cyclic polytope's bound).
std::vector<Point> moment_curve_points(Dice& dice, std::size_t dimension, Count count);

// Weighted point sets, and sets with equal points. Book: Section 5.2, weighted Delaunay
// triangulations.

// Integer points with weights within 100 of 0, small beside squared distances or not.
PointsCase integer_weights(Dice& dice, std::size_t dimension, Count count);

// Weights |p|² and |p|² + 1, so that the lifted points lie on two parallel hyperplanes: degenerate
// for any points.
PointsCase lifted_to_parallel_planes(Dice& dice, std::size_t dimension, Count count);

// The corners of a simplex (as many as there is room for) and integer points of its interior, about
// half of which have a weight so low that they are submerged below the lifted simplex, far from its
// facets: they are not vertices of the weighted Delaunay triangulation.
PointsCase submerged_points(Dice& dice, std::size_t dimension, Count count);

// Integer points within 3 of the origin, some of them twice or more often; with two points or more
// there is always a duplicate. Programs should name the duplicates, or merge them.
PointsCase duplicate_points(Dice& dice, std::size_t dimension, Count count);

// Point sets that lie in flats or near them, in clusters, or at odd scales.
// As in point_sets.hpp: distinct points, as many as `count` says.

// Uniform in the cube [−1, 1]^d, multiples of 2^-30: generic except by rare accident.
std::vector<Point> uniform_points(Dice& dice, std::size_t dimension, Count count);

// Points of a flat of a random dimension k < d (Book: Section 4.1, the affine hull of S).
// Requires: dimension >= 2.
std::vector<Point> lower_dimensional_points(Dice& dice, std::size_t dimension, Count count);

// Points of the hyperplane x_d = 0, of a grid or a circle, and up to two others: every simplex has
// an apex off the hyperplane, and the convex hull has a facet with many coplanar points. Requires:
// dimension >= 2.
std::vector<Point> pyramid_points(Dice& dice, std::size_t dimension, Count count);

// Points of the boundary of the cube [0, 4]^d: all are on the convex hull, few are its vertices.
// Requires: dimension >= 2.
std::vector<Point> box_boundary_points(Dice& dice, std::size_t dimension, Count count);

// Integer points with the last coordinate times 2^-k, k from 10 to 50: almost coplanar, but not
// quite. Requires: dimension >= 2.
std::vector<Point> slab_points(Dice& dice, std::size_t dimension, Count count);

// Up to three clusters within 2^-10 of integer points that may lie 1,000 apart.
std::vector<Point> cluster_points(Dice& dice, std::size_t dimension, Count count);

// Integer points, each times its own 2^-k, k from 0 to 50: clusters within clusters at the origin.
std::vector<Point> nested_points(Dice& dice, std::size_t dimension, Count count);

// Integer points times 2^990 (about 1e298), or 2^-1000 (about 1e-301): exactly degenerate as
// integers are, but squares overflow or underflow in doubles.
std::vector<Point> huge_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> tiny_points(Dice& dice, std::size_t dimension, Count count);

// Every coordinate with an exponent of its own, from 2^-995 to 2^995: 1e-300 beside 1e300.
std::vector<Point> far_apart_exponent_points(Dice& dice, std::size_t dimension, Count count);

}  // namespace circumspect::generators
