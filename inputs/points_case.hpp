// A generated point set, printed so that a failing case can be pasted into a file.
#pragma once

#include <iosfwd>
#include <vector>

#include "reference/kernel/exact/point.hpp"

namespace circumspect::generators {

struct PointsCase {
  std::vector<Point> points;
  std::vector<Rational> weights = {};  // empty, or one for each point
};

// As a `.node` file with exact rationals; the weights are its attribute.
std::ostream& operator<<(std::ostream& out, const PointsCase& set);

}  // namespace circumspect::generators
