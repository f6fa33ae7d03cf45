// Random point sets for RapidCheck, by family. Each function makes sets of 0 to `max_points`
// distinct points of one dimension; a failing set shrinks by dropping points and by moving what
// the points are made of towards small integers.
#pragma once

#include <cstddef>
#include <vector>

#include <rapidcheck.h>

#include "inputs/points_case.hpp"
#include "reference/kernel/exact/point.hpp"

namespace circumspect::generators {

using PointSets = rc::Gen<std::vector<Point>>;

// General position, mostly (Book: Section 2.9, "generic").
PointSets integer_points(std::size_t dimension, std::size_t max_points);
PointSets rational_points(std::size_t dimension, std::size_t max_points);
PointSets dyadic_points(std::size_t dimension, std::size_t max_points);

// Doubles of magnitudes from 2^-300 to 2^300 beside each other: what floating-point filters and
// tolerances fail on.
PointSets extreme_points(std::size_t dimension, std::size_t max_points);

// Up to three clusters of points that are a few units in the last place apart: nearly coplanar,
// nearly cospherical, nearly equal.
PointSets clustered_points(std::size_t dimension, std::size_t max_points);

// Each point over its own denominator of about 900 bits, the denominators of two points mostly
// coprime: sets that cannot be scaled to integers in common.
PointSets unrelated_denominator_points(std::size_t dimension, std::size_t max_points);

// A part of the grid {0, 1, 2}^d: cospherical, coplanar and collinear all at once; Delaunay
// subdivisions whose cells are not simplices (Book: Section 4.1, 4.2).
PointSets grid_points(std::size_t dimension, std::size_t max_points);

// Some of the corners of a cube, its centre and the centres of its facets.
PointSets cube_points(std::size_t dimension, std::size_t max_points);

// Exactly cospherical points (Book: Section 2.9, the perturbation's reason to be). Rational ones by
// stereographic projection, each over its own denominator; integer ones as the images of one point
// under the symmetries of the cube. Requires: dimension >= 2.
PointSets sphere_points(std::size_t dimension, std::size_t max_points);
PointSets integer_sphere_points(std::size_t dimension, std::size_t max_points);

// Points of a flat in a higher dimension (Book: Section 4.1, "if the affine hull of S is
// k-dimensional"): sets of a family in R^k carried into R^d by a random similarity, so that grids
// stay grids and circles circles. Requires: flat_dimension <= dimension.
PointSets embedded(const PointSets& sets, std::size_t flat_dimension, std::size_t dimension);
PointSets line_points(std::size_t dimension, std::size_t max_points);
// Requires: dimension >= 2. Circles and grids among them.
PointSets plane_points(std::size_t dimension, std::size_t max_points);

// Points on two skew lines: a Delaunay triangulation of quadratic size, and the only one there is
// (Book: Section 4.1). Requires: dimension >= 3.
PointSets skew_line_points(std::size_t dimension, std::size_t max_points);

// Points (t, t², …, t^d): every d+1 of them affinely independent, and, in dimension 3 and above,
// every pair an edge (Book: Section 4.1, the cyclic polytope's bound).
PointSets moment_curve_points(std::size_t dimension, std::size_t max_points);

// One of the families in (mostly) general position; one of the degenerate families, mostly grids,
// spheres, planes and lines; any family at all.
PointSets generic_point_set(std::size_t dimension, std::size_t max_points);
PointSets degenerate_point_set(std::size_t dimension, std::size_t max_points);
PointSets any_point_set(std::size_t dimension, std::size_t max_points);

// The same, to be printed well.
rc::Gen<PointsCase> unweighted(const PointSets& sets);

// With weights: small rationals, or such that the lifted points lie on two parallel hyperplanes,
// hence degenerate for any points.
rc::Gen<PointsCase> weighted(const PointSets& sets, std::size_t max_points);

// Sets that begin with k+1 affinely independent points, k the dimension of their hull, and have at
// least one point more: a simplex, and queries within its affine hull. Any family, with and without
// weights, k from 1 to `dimension`.
rc::Gen<PointsCase> simplex_and_queries(std::size_t dimension);

// The sets of `cases` moved so that such a simplex comes first, those without one left out.
rc::Gen<PointsCase> simplex_first(const rc::Gen<PointsCase>& cases);

}  // namespace circumspect::generators
