// The predicates: signs of orientation and in-ball determinants.
#pragma once

#include <cstdint>
#include <optional>

#include "python/values.hpp"

namespace circumspect::python {

// Of the flat coordinates of all points: an array of doubles, or a list of exact texts.
int predicate(bool in_ball, std::int64_t dimension, const Object& numbers);

// Of a tuple of points that are tuples or lists of doubles, in a microsecond: no array is made.
// Nothing if they are anything else, or as many as make no sense, which the package looks at.
std::optional<int> plain_predicate(bool in_ball, const Object& points);

}  // namespace circumspect::python
