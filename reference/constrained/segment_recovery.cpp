#include "reference/constrained/segment_recovery.hpp"

#include <limits>

#include "reference/constrained/edge_protection.hpp"

namespace circumspect::constrained {

std::vector<PointOnSegment> points_for_unprotected_subsegments(const PointSet& points,
                                                               const StarIndex& canonical_delaunay,
                                                               const SplitSegments& segments,
                                                               SubsegmentCondition condition) {
  std::vector<PointOnSegment> added;
  for (const Subsegment& subsegment : segments.subsegments()) {
    const bool is_fine =
        condition == SubsegmentCondition::kInCanonical
            ? !canonical_delaunay.star(subsegment.edge).empty()
            : is_strongly_delaunay_edge(points, canonical_delaunay, subsegment.edge);
    if (is_fine) continue;
    const auto vertex = static_cast<Vertex>(points.size() + added.size());
    added.push_back({vertex, subsegment.segment, segments.where_to_split(subsegment)});
  }
  return added;
}

RecoveredSegments recover_segments(const PiecewiseLinearComplex& complex) {
  return *recover_segments(complex, std::numeric_limits<std::size_t>::max());
}

tl::expected<RecoveredSegments, SteinerLimitReached> recover_segments(
    const PiecewiseLinearComplex& complex, std::size_t most_steiner_points) {
  SplitSegments segments(complex);
  PointSet points = complex.points;
  while (true) {
    const auto added = points_for_unprotected_subsegments(
        points, canonical_delaunay(points), segments, SubsegmentCondition::kStronglyDelaunay);
    if (added.empty()) break;
    std::vector<Point> all = points.points();
    for (const PointOnSegment& point : added) {
      all.push_back(segments.point_at(point.segment, point.parameter));
      segments.add(point);
    }
    if (segments.added().size() > most_steiner_points) {
      return tl::unexpected(SteinerLimitReached{.on_segments = segments.added().size()});
    }
    points = PointSet(std::move(all));
  }
  return RecoveredSegments{segments.augmented(points), segments.added()};
}

}  // namespace circumspect::constrained
