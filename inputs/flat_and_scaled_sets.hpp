// Point sets that lie in flats or near them, in clusters, or at odd scales.
// As in point_sets.hpp: 0 to `max_points` distinct points, which shrink.
#pragma once

#include <cstddef>

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// Uniform in the cube [−1, 1]^d, multiples of 2^-30: generic but for rare accidents.
PointSets uniform_points(std::size_t dimension, std::size_t max_points);

// Points of a flat of a random dimension k < d (Book: Section 4.1, the affine hull of S).
// Requires: dimension >= 2.
PointSets lower_dimensional_points(std::size_t dimension, std::size_t max_points);

// Points of the hyperplane x_d = 0, of a grid or a circle, and up to two others: every simplex has an
// apex, and the convex hull a facet with many coplanar points. Requires: dimension >= 2.
PointSets pyramid_points(std::size_t dimension, std::size_t max_points);

// Points of the boundary of the cube [0, 4]^d: all are on the convex hull, few are its vertices.
// Requires: dimension >= 2.
PointSets box_boundary_points(std::size_t dimension, std::size_t max_points);

// Integer points with the last coordinate times 2^-k, k from 10 to 50: almost coplanar, not quite.
// Requires: dimension >= 2.
PointSets slab_points(std::size_t dimension, std::size_t max_points);

// Up to three clusters within 2^-10 of integer points that may lie 1,000 apart.
PointSets cluster_points(std::size_t dimension, std::size_t max_points);

// Integer points, each times its own 2^-k, k from 0 to 50: clusters within clusters at the origin.
PointSets nested_points(std::size_t dimension, std::size_t max_points);

// Integer points times 2^990 (about 1e298), or 2^-1000 (about 1e-301): exactly degenerate as integers
// are, but squares overflow or underflow in doubles.
PointSets huge_points(std::size_t dimension, std::size_t max_points);
PointSets tiny_points(std::size_t dimension, std::size_t max_points);

// Every coordinate with an exponent of its own, from 2^-995 to 2^995: 1e-300 beside 1e300.
PointSets far_apart_exponent_points(std::size_t dimension, std::size_t max_points);

}  // namespace circumspect::generators
