// A generated point set, printed so that a failing case can be pasted into a file.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <vector>

#include <circumspect/subject.hpp>

#include "reference/kernel/exact/point.hpp"

namespace circumspect::generators {

struct PointsCase {
  std::vector<Point> points;
  std::vector<Rational> weights = {};  // empty, or one for each point
};

// The points at these places, with their weights.
PointsCase chosen(const PointsCase& set, const std::vector<std::size_t>& places);

// As a `.node` file with exact rationals; the weights are its attribute.
std::ostream& operator<<(std::ostream& out, const PointsCase& set);

// ---- As arrays ----
// Generated sets as arrays of doubles, for programs under test, and back.

// Each number rounded to the nearest double: call in_doubles first, so that what the program sees is
// what is judged. `dimension`: that of an empty set, which has no point to tell.
PointArray array(const PointsCase& set, std::size_t dimension = 3);

// The exact values. Requires: all numbers are finite; coordinates.size() is a multiple of dimension;
// weights are none or one a point.
PointsCase from(const PointArray& points);

}  // namespace circumspect::generators
