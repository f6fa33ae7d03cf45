// Boxes around simplices, for searches among them.
#pragma once

#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect::check {

// Of the first three coordinates, which is enough for a filter; on a line the second is 0.
std::vector<Box> boxes_around(const std::vector<Point>& points,
                              const std::vector<Simplex>& simplices);

}  // namespace circumspect::check
