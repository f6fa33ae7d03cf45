// The corners of a listed cell within a box.
#pragma once

#include <vector>

#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::check {

// The extreme points of what definition::listed_corners returns. A cell that is bounded and inside
// of the box has its own corners. Otherwise the halfspaces n · x <= c that hold the cell are a
// polytope of pairs (n, c), if n and c are bounded: each listed corner p demands n · p <= c, each
// direction r demands n · r <= 0. Its corners suffice to cut the cell out of the box.
// Requires: every corner names a vertex.
std::vector<Point> corners_of_listed(const VoronoiDiagram& diagram, Vertex site,
                                     const JudgedBox& box);

}  // namespace circumspect::check
