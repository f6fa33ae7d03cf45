// Which regions of a domain in the plane its faces leave empty.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/regions.hpp"

namespace circumspect {

// A point in each region that is enclosed and that no face covers: seeds of holes. A face covers
// what its lines enclose, less its holes. Requires: the edges of the faces are walls; faces do not
// overlap.
std::vector<Point> points_without_face(const std::vector<PolygonLines>& faces,
                                       const Regions& regions, const PointSet& points);

// The same of faces whose lines are rings: each covers what an odd number of its rings enclose,
// whatever the others cover. Rings may cross where they have a common vertex.
std::vector<Point> points_without_rings(const std::vector<PolygonLines>& faces,
                                        const Regions& regions);

// A ring of a face, not the first, that is no hole of what the first encloses.
struct RingThatIsNoHole {
  std::size_t face, ring;
  std::optional<std::size_t> in_hole;  // the ring that it lies in; else it lies outside the first
};
std::vector<RingThatIsNoHole> rings_that_are_no_holes(const std::vector<PolygonLines>& faces,
                                                      const Regions& regions);

}  // namespace circumspect
