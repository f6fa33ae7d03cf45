// Exact lengths, areas and volumes, which may be added and compared within one line, plane or
// space.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect {

// k! times the length, area or volume of the projection of a k-simplex on k axes; and of several,
// added up. The measure itself need not be rational, but in one flat all projections are smaller by
// one factor. Requires: k + 1 vertices each.
Rational measure(const PointSet& points, std::span<const std::size_t> axes, const Simplex& simplex);
Rational measure(const PointSet& points, std::span<const std::size_t> axes,
                 const std::vector<Simplex>& simplices);

}  // namespace circumspect
