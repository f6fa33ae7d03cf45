// Point sets for properties that hold of all of them.
#pragma once

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// A set of any family, every other one of a degenerate family; weighted every other time.
rc::Gen<PointsCase> any_case(std::size_t dimension, std::size_t max_points);
rc::Gen<PointsCase> any_unweighted_case(std::size_t dimension, std::size_t max_points);

}  // namespace circumspect::generators
