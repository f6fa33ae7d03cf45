// A generated point set, printed so that a failing case can be pasted into a file.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <vector>

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

}  // namespace circumspect::generators
