// Inputs as programs see them: every number a double.
#pragma once

#include "inputs/cases.hpp"

namespace circumspect::generators {

// To nearest, ties to even. Requires: the result is finite.
double nearest_double(const Rational& value);

// Also false for numbers beyond all doubles.
bool is_double(const Rational& value);

// Each coordinate and weight rounded to the nearest double (its exact value). What was exactly
// cospherical need not be so afterwards. The first of points that become equal is kept, unless
// `keep_repeated_points`.
PointsCase in_doubles(const PointsCase& set, bool keep_repeated_points = false);

// The vertices and hole seeds rounded. Valid again if the vertices were doubles and the seeds are
// not next to a wall, as in all families of complex_families.hpp.
ComplexCase in_doubles(ComplexCase whole);

// The points in the order given, without repetition, each with its first weight.
PointsCase without_repeated_points(const PointsCase& set);

}  // namespace circumspect::generators
