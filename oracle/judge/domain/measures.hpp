// Lengths, areas and volumes, exact. All are k! times the measure of a projection on k axes, so that
// within one line, plane or space they can be added and compared.
#pragma once

#include <vector>

#include "reference/kernel/piecewise_linear/regions.hpp"

namespace circumspect::check {

using Axes = std::vector<std::size_t>;

Rational measure(const PointSet& points, const Axes& axes, const Simplex& simplex);
Rational measure(const PointSet& points, const Axes& axes, const std::vector<Simplex>& simplices);

// Of the common part of two triangles in one plane.
Rational common_area(const Axes& axes, const std::vector<Point>& a, const std::vector<Point>& b);

// Of all regions that are inside, from the walls around them. Requires: an enclosed domain.
Rational measure_of_inside(const PiecewiseLinearComplex& complex, const Regions& regions);

// Of the convex hull. Requires: the points span their space.
Rational measure_of_hull(const PointSet& points);

}  // namespace circumspect::check
