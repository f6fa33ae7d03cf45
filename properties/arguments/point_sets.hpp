// Random point sets for properties. A failing set shrinks by dropping points and by moving the
// others towards small integers.
#pragma once

#include <cstddef>
#include <vector>

#include "inputs/point_sets.hpp"
#include "inputs/set_parts.hpp"
#include "properties/arguments/generated.hpp"

namespace circumspect::generators {

using PointSets = rc::Gen<std::vector<Point>>;

// Sets of one of the families of inputs/, of 0 to `max_points` points.
PointSets sets_of(Sets family, std::size_t dimension, std::size_t max_points);

// Of one of the families in (mostly) general position; of one of the degenerate families, mostly
// grids, spheres, planes and lines; of any of them.
std::vector<Point> generic_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> degenerate_points(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> any_points(Dice& dice, std::size_t dimension, Count count);
PointSets generic_point_set(std::size_t dimension, std::size_t max_points);
PointSets degenerate_point_set(std::size_t dimension, std::size_t max_points);
PointSets any_point_set(std::size_t dimension, std::size_t max_points);

// Sets of points of a flat in a higher dimension (Book: Section 4.1, "if the affine hull of S is
// k-dimensional"), carried there by a random similarity. Requires: the sets have no higher
// dimension.
PointSets embedded(const PointSets& sets, std::size_t dimension);

// The same, to be printed well.
rc::Gen<PointsCase> unweighted(const PointSets& sets);

// With weights: small rationals, or such that the lifted points lie on two parallel hyperplanes,
// hence degenerate for any points.
rc::Gen<PointsCase> weighted(const PointSets& sets);

// A set of any family, every other one of a degenerate family; weighted every other time.
rc::Gen<PointsCase> any_case(std::size_t dimension, std::size_t max_points);
rc::Gen<PointsCase> any_unweighted_case(std::size_t dimension, std::size_t max_points);

// Sets that begin with k+1 affinely independent points, k the dimension of their hull, and have at
// least one point more: a simplex, and queries within its affine hull. Any family, with and without
// weights, k from 1 to `dimension`.
rc::Gen<PointsCase> simplex_and_queries(std::size_t dimension);

// The sets of `cases` moved so that such a simplex comes first, those without one left out.
rc::Gen<PointsCase> simplex_first(const rc::Gen<PointsCase>& cases);

}  // namespace circumspect::generators
