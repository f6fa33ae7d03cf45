// Stage 2 of `validated`: do vertices and segments form a simplicial complex?
#include <algorithm>

#include "reference/piecewise_linear/breaches.hpp"
#include "reference/piecewise_linear/cell_boxes.hpp"
#include "reference/piecewise_linear/incidence.hpp"
#include "reference/predicates/intersection.hpp"

namespace circumspect {

// Two segments of one line that overlap have an end of one inside the other, or are the same.
void find_segment_breaches(const PointSet& points, const std::vector<Simplex>& segments,
                           BreachList& found) {
  if (segments.empty()) return;
  const Configuration& configuration = points.configuration();
  const CellBoxes boxes(points);
  const BoxIndex vertex_index(boxes.of_vertices());
  const BoxIndex segment_index = boxes.index_of(segments);
  for (std::size_t i = 0; i < segments.size() && !found.is_full(); ++i) {
    const Simplex& a = segments[i];
    const Box box = boxes.of(a);
    for (const std::size_t place : vertex_index.meeting(box)) {
      const auto v = static_cast<Vertex>(place);
      if (contains(a, v) || !lies_inside_segment(configuration, v, a)) continue;
      found.add({BreachKind::kVertexInSegment, {v}, {a}, {}, points[v]});
    }
    for (const std::size_t j : segment_index.meeting(box)) {
      const Simplex& b = segments[j];
      if (j <= i || contains(a, b[0]) || contains(a, b[1])) continue;
      if (!segments_cross(configuration, a, b)) continue;
      const auto common = intersection(coordinates(points, a), coordinates(points, b));
      found.add({BreachKind::kCrossingSegments, {}, {a, b}, {}, common.front()});
    }
  }
}

}  // namespace circumspect
