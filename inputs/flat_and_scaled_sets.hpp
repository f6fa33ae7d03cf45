// Point sets that lie in flats or near them, in clusters, or at odd scales.
// As in point_sets.hpp: distinct points, as many as `count` says.
#pragma once

#include <cstddef>
#include <vector>

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// Uniform in the cube [−1, 1]^d, multiples of 2^-30: generic but for rare accidents.
std::vector<Point> uniform_points(Dice& dice, std::size_t dimension, Count count);

// Points of a flat of a random dimension k < d (Book: Section 4.1, the affine hull of S).
// Requires: dimension >= 2.
std::vector<Point> lower_dimensional_points(Dice& dice, std::size_t dimension, Count count);

// Points of the hyperplane x_d = 0, of a grid or a circle, and up to two others: every simplex has an
// apex, and the convex hull a facet with many coplanar points. Requires: dimension >= 2.
std::vector<Point> pyramid_points(Dice& dice, std::size_t dimension, Count count);

// Points of the boundary of the cube [0, 4]^d: all are on the convex hull, few are its vertices.
// Requires: dimension >= 2.
std::vector<Point> box_boundary_points(Dice& dice, std::size_t dimension, Count count);

// Integer points with the last coordinate times 2^-k, k from 10 to 50: almost coplanar, not quite.
// Requires: dimension >= 2.
std::vector<Point> slab_points(Dice& dice, std::size_t dimension, Count count);

// Up to three clusters within 2^-10 of integer points that may lie 1,000 apart.
std::vector<Point> cluster_points(Dice& dice, std::size_t dimension, Count count);

// Integer points, each times its own 2^-k, k from 0 to 50: clusters within clusters at the origin.
std::vector<Point> nested_points(Dice& dice, std::size_t dimension, Count count);

// Integer points times 2^990 (about 1e298), or 2^-1000 (about 1e-301): exactly degenerate as integers
// are, but squares overflow or underflow in doubles.
std::vector<Point> huge_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> tiny_points(Dice& dice, std::size_t dimension, Count count);

// Every coordinate with an exponent of its own, from 2^-995 to 2^995: 1e-300 beside 1e300.
std::vector<Point> far_apart_exponent_points(Dice& dice, std::size_t dimension, Count count);

}  // namespace circumspect::generators
