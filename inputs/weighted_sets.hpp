// Weighted point sets, and sets with equal points. Book: Section 5.2, weighted Delaunay triangulations.
#pragma once

#include <cstddef>

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// Integer points with weights within 100 of 0, small beside squared distances or not.
PointsCase integer_weights(Dice& dice, std::size_t dimension, Count count);

// Weights |p|² and |p|² + 1, so that the lifted points lie on two parallel hyperplanes: degenerate for
// any points.
PointsCase lifted_to_parallel_planes(Dice& dice, std::size_t dimension, Count count);

// The corners of a simplex (as many as there is room for) and integer points of its interior, about half of
// which have a weight so low that they are submerged below the lifted simplex, far from its facets:
// they are no vertices of the weighted Delaunay triangulation.
PointsCase submerged_points(Dice& dice, std::size_t dimension, Count count);

// Integer points within 3 of the origin, some of them twice or more often; never without a duplicate if
// there are two points. Programs should say which, or merge them.
PointsCase duplicate_points(Dice& dice, std::size_t dimension, Count count);

}  // namespace circumspect::generators
