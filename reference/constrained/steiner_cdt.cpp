#include "reference/constrained/steiner_cdt.hpp"

#include <limits>
#include <stdexcept>

#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"

namespace circumspect::constrained {

namespace {

// The points of a round, which can be searched by position.
class PointsNear {
 public:
  explicit PointsNear(const PointSet& points)
      : points_(points), index_(CellBoxes(points).of_vertices()) {}

  // The points in the closed diametral ball of the edge, without its ends.
  std::vector<Point> in_diametral_ball(const Simplex& edge) const {
    const Point& a = points_[edge[0]];
    const Point& b = points_[edge[1]];
    const Box box = box_around_ball(a, b);
    std::vector<Point> found;
    const auto take = [&](const Point& point) {
      if (sign(inner_product(a - point, b - point)) <= 0 && point != a && point != b) {
        found.push_back(point);
      }
    };
    for (const std::size_t place : index_.meeting(box)) take(points_[static_cast<Vertex>(place)]);
    for (const auto& [around, point] : added_) {
      if (may_meet(around, box)) take(point);
    }
    return found;
  }

  void add(const Point& point) { added_.push_back({box_around(point), point}); }

 private:
  // The sum of the coordinates' distances is at least the distance.
  static Box box_around_ball(const Point& a, const Point& b) {
    const Point middle = Rational(1, 2) * (a + b);
    Rational reach = 0;
    for (const Rational& coordinate : a - middle) reach += abs(coordinate);
    return cube(middle, reach);
  }

  const PointSet& points_;
  BoxIndex index_;
  std::vector<std::pair<Box, Point>> added_;
};

}  // namespace

std::vector<PointOnSegment> points_for_unprotected_subsegments(const PointSet& points,
                                                               const StarIndex& canonical_delaunay,
                                                               const SplitSegments& segments,
                                                               SubsegmentCondition condition) {
  std::vector<PointOnSegment> added;
  PointsNear near(points);
  for (const Subsegment& subsegment : segments.subsegments()) {
    const bool is_fine =
        condition == SubsegmentCondition::kInCanonical
            ? !canonical_delaunay.star(subsegment.edge).empty()
            : is_strongly_delaunay_edge(points, canonical_delaunay, subsegment.edge);
    if (is_fine) continue;
    const auto vertex = static_cast<Vertex>(points.size() + added.size());
    added.push_back({vertex, subsegment.segment,
                     segments.where_to_split(subsegment, near.in_diametral_ball(subsegment.edge))});
    near.add(segments.point_at(subsegment.segment, added.back().parameter));
  }
  return added;
}

RecoveredSegments recover_segments(const PiecewiseLinearComplex& complex) {
  return *recover_segments(complex, std::numeric_limits<std::size_t>::max());
}

tl::expected<RecoveredSegments, SteinerLimitReached> recover_segments(
    const PiecewiseLinearComplex& complex, std::size_t most_steiner_points,
    const Progress& progress) {
  SplitSegments segments(complex);
  PointSet points = complex.points;
  while (true) {
    const auto added =
        points_for_unprotected_subsegments(points, canonical_delaunay(points, progress), segments,
                                           SubsegmentCondition::kStronglyDelaunay);
    if (added.empty()) break;
    std::vector<Point> all = points.points();
    for (const PointOnSegment& point : added) {
      all.push_back(segments.point_at(point.segment, point.parameter));
      segments.add(point);
    }
    tell(progress, "Steiner points added", segments.added().size());
    if (segments.added().size() > most_steiner_points) {
      return tl::unexpected(SteinerLimitReached{.on_segments = segments.added().size()});
    }
    points = PointSet(std::move(all));
  }
  return RecoveredSegments{segments.augmented(points), segments.added()};
}

namespace {

template <typename Expected>
PlcTriangulation value_of(Expected result) {
  if (!result) throw std::logic_error("an edge-protected complex has a CDT");
  return *std::move(result);
}

}  // namespace

PlcTriangulation cdt_of_edge_protected(const PiecewiseLinearComplex& complex,
                                       CdtAlgorithm algorithm, const Progress& progress) {
  if (complex.ambient_dimension() == 2) {
    return planar_cdt(complex, PlanarAlgorithm::kSegmentInsertion);
  }
  switch (algorithm) {
    case CdtAlgorithm::kGiftWrapping:
      return value_of(gift_wrapping_cdt(complex, progress));
    case CdtAlgorithm::kPolygonFlips:
      return value_of(cdt_by_polygon_insertion(complex, {PolygonInsertion::kFlips, {}, progress}));
    case CdtAlgorithm::kPolygonCavities:
      return value_of(
          cdt_by_polygon_insertion(complex, {PolygonInsertion::kCavities, {}, progress}));
  }
  throw std::logic_error("no such algorithm");
}

SteinerCdt steiner_cdt(const PiecewiseLinearComplex& complex, CdtAlgorithm algorithm) {
  return *steiner_cdt(complex, algorithm, std::numeric_limits<std::size_t>::max());
}

tl::expected<SteinerCdt, SteinerLimitReached> steiner_cdt(const PiecewiseLinearComplex& complex,
                                                          CdtAlgorithm algorithm,
                                                          std::size_t most_steiner_points,
                                                          const Progress& progress) {
  if (complex.ambient_dimension() == 2) return SteinerCdt{complex, planar_cdt(complex), {}};
  auto recovered = recover_segments(complex, most_steiner_points, progress);
  if (!recovered) return tl::unexpected(recovered.error());
  PlcTriangulation triangulation = cdt_of_edge_protected(recovered->complex, algorithm, progress);
  return SteinerCdt{std::move(recovered->complex), std::move(triangulation),
                    std::move(recovered->steiner_points)};
}

}  // namespace circumspect::constrained
