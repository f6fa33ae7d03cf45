#include "reference/constrained/conforming_delaunay.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/segment_recovery.hpp"
#include "reference/constrained/steiner_cdt.hpp"
#include "reference/constrained/subfacets.hpp"

namespace circumspect::constrained {
namespace {

// A point that may be added to a polygon, and the subfacet's smallest circumball.
struct Candidate {
  Point point;
  Rational squared_radius;
};

class Refinement {
 public:
  Refinement(const PiecewiseLinearComplex& complex, std::size_t most_steiner_points)
      : complex_(complex),
        most_steiner_points_(most_steiner_points),
        segments_(complex),
        points_(complex.points),
        polygons_of_segment_(complex.segments.size()) {
    std::map<Simplex, std::size_t> place_of;
    for (std::size_t i = 0; i < complex.segments.size(); ++i) place_of[complex.segments[i]] = i;
    for (std::size_t i = 0; i < complex.polygons.size(); ++i) {
      vertices_.push_back(complex.polygons[i].vertices);
      for (const Simplex& segment : complex.polygons[i].segments) {
        polygons_of_segment_[place_of.at(segment)].push_back(i);
      }
    }
  }

  tl::expected<ConformingDelaunay, SteinerLimitReached> run() {
    while (true) {
      const StarIndex canonical = canonical_delaunay(points_);
      fresh_points_ = points_.points();
      refine(canonical);
      if (fresh_points_.size() == points_.size()) break;
      if (fresh_points_.size() > complex_.points.size() + most_steiner_points_) {
        return tl::unexpected(SteinerLimitReached{segments_.added().size(), in_polygons_.size()});
      }
      points_ = PointSet(std::move(fresh_points_));
    }
    PiecewiseLinearComplex augmented = segments_.augmented(points_, in_polygons_);
    // Its cells are unions of Delaunay simplices. So its CDT is part of the Delaunay triangulation.
    PlcTriangulation triangulation = cdt_of_edge_protected(augmented);
    return ConformingDelaunay{std::move(augmented), std::move(triangulation), segments_.added(),
                              std::move(in_polygons_)};
  }

 private:
  void refine(const StarIndex& canonical) {
    const auto added = points_for_unprotected_subsegments(points_, canonical, segments_,
                                                          SubsegmentCondition::kInCanonical);
    for (const PointOnSegment& point : added) add(point);
    if (!added.empty()) return;
    std::set<Simplex> to_split;
    for (std::size_t i = 0; i < complex_.polygons.size(); ++i) refine(canonical, i, to_split);
    for (const Subsegment& subsegment : segments_.subsegments()) {
      if (!to_split.contains(subsegment.edge)) continue;
      add({static_cast<Vertex>(fresh_points_.size()), subsegment.segment,
           segments_.where_to_split(subsegment)});
    }
  }

  void add(const PointOnSegment& point) {
    fresh_points_.push_back(segments_.point_at(point.segment, point.parameter));
    segments_.add(point);
    for (const std::size_t i : polygons_of_segment_[point.segment]) {
      vertices_[i].push_back(point.vertex);
    }
  }

  // Does what one polygon needs.
  void refine(const StarIndex& canonical, std::size_t i, std::set<Simplex>& to_split) {
    const Polygon& polygon = complex_.polygons[i];
    std::vector<Simplex> missing = subfacets(points_, polygon, vertices_[i]);
    std::erase_if(missing, [&](const Simplex& facet) { return !canonical.star(facet).empty(); });
    if (missing.empty()) return;
    const std::vector<Simplex> subsegments = subsegments_of(i);
    std::vector<Simplex> encroached = subsegments;
    std::erase_if(encroached, [&](const Simplex& subsegment) {
      return has_empty_diametral_ball(points_, canonical, subsegment);
    });
    to_split.insert(encroached.begin(), encroached.end());
    if (!encroached.empty()) return;
    std::vector<Candidate> accepted;
    for (const Simplex& subfacet : missing) {
      const Ball ball = circumball(points_, subfacet);
      Candidate candidate{near_circumcentre(points_, polygon, ball), ball.squared_radius};
      const std::vector<Simplex> in_the_way =
          subsegments_in_the_way(polygon, subsegments, subfacet, candidate);
      to_split.insert(in_the_way.begin(), in_the_way.end());
      if (in_the_way.empty() && keeps_its_distance(candidate, accepted)) {
        accepted.push_back(std::move(candidate));
      }
    }
    for (Candidate& candidate : accepted) {
      const auto vertex = static_cast<Vertex>(fresh_points_.size());
      fresh_points_.push_back(std::move(candidate.point));
      vertices_[i].push_back(vertex);
      in_polygons_.push_back({vertex, i});
    }
  }

  std::vector<Simplex> subsegments_of(std::size_t i) const {
    std::vector<Simplex> own;
    for (const Subsegment& subsegment : segments_.subsegments()) {
      const std::vector<std::size_t>& polygons = polygons_of_segment_[subsegment.segment];
      if (std::find(polygons.begin(), polygons.end(), i) != polygons.end()) {
        own.push_back(subsegment.edge);
      }
    }
    return own;
  }

  // Those subsegments whose closed diametral balls contain the point; or else, if it is outside the
  // polygon, one that is between it and the subfacet.
  std::vector<Simplex> subsegments_in_the_way(const Polygon& polygon,
                                              const std::vector<Simplex>& subsegments,
                                              const Simplex& subfacet,
                                              const Candidate& candidate) const {
    std::vector<Simplex> in_the_way;
    for (const Simplex& subsegment : subsegments) {
      if (sign(inner_product(points_[subsegment[0]] - candidate.point,
                             points_[subsegment[1]] - candidate.point)) <= 0) {
        in_the_way.push_back(subsegment);
      }
    }
    if (!in_the_way.empty() || is_in_polygon(points_, polygon, candidate.point)) return in_the_way;
    const Point middle = barycentre(coordinates(points_, subfacet));
    const auto between =
        std::find_if(subsegments.begin(), subsegments.end(), [&](const Simplex& subsegment) {
          return do_meet(polygon.axes, middle, candidate.point, points_[subsegment[0]],
                         points_[subsegment[1]]);
        });
    assert(between != subsegments.end());  // The boundary is a union of them.
    return {*between};
  }

  static bool keeps_its_distance(const Candidate& candidate,
                                 const std::vector<Candidate>& accepted) {
    return std::all_of(accepted.begin(), accepted.end(), [&](const Candidate& other) {
      return 4 * squared_distance(candidate.point, other.point) >
             std::max(candidate.squared_radius, other.squared_radius);
    });
  }

  const PiecewiseLinearComplex& complex_;
  std::size_t most_steiner_points_;
  SplitSegments segments_;
  PointSet points_;
  std::vector<Point> fresh_points_;  // the points and those that this round adds
  std::vector<PointInPolygon> in_polygons_;
  std::vector<std::vector<Vertex>> vertices_;  // by polygon
  std::vector<std::vector<std::size_t>> polygons_of_segment_;
};

}  // namespace

tl::expected<ConformingDelaunay, SteinerLimitReached> conforming_delaunay(
    const PiecewiseLinearComplex& complex, std::size_t most_steiner_points) {
  return Refinement(complex, most_steiner_points).run();
}

}  // namespace circumspect::constrained
