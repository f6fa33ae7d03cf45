#include "reference/piecewise_linear/regions.hpp"

#include <algorithm>
#include <cassert>

#include "reference/exact/linear_program.hpp"
#include "reference/piecewise_linear/wall_sides.hpp"

namespace circumspect {

Regions::Regions(const PointSet& points, const std::vector<Simplex>& walls,
                 const std::vector<Point>& hole_seeds, DomainKind kind)
    : Regions(points, walls, {}, hole_seeds, kind) {}

Regions::Regions(const PiecewiseLinearComplex& complex)
    : Regions(complex.points, circumspect::walls(complex), complex.segments, complex.hole_seeds,
              complex.kind) {}

Regions::Regions(const PointSet& points, const std::vector<Simplex>& walls,
                 const std::vector<Simplex>& segments, const std::vector<Point>& hole_seeds,
                 DomainKind kind)
    : kind_(kind),
      walls_(std::make_shared<const WallSet>(points, walls)),
      cells_(std::make_shared<const NearbyCells>(points, segments)) {
  WallSides sides = wall_sides(points, *walls_);
  region_of_side_ = std::move(sides.region);
  where_.assign(sides.regions, Where::kInside);
  if (kind == DomainKind::kEnclosed) {
    where_[kUnbounded] = Where::kOutside;
    make_holes(hole_seeds);
    return;
  }
  hull_of_ = std::make_shared<const std::vector<Point>>(points.points());
  if (points.dimension() < static_cast<int>(points.ambient_dimension())) {
    where_[kUnbounded] = Where::kOutside;
  }
  for (std::size_t i = 0; i < hole_seeds.size(); ++i) ignored_seeds_.push_back(i);
}

void Regions::make_holes(const std::vector<Point>& hole_seeds) {
  for (std::size_t i = 0; i < hole_seeds.size(); ++i) {
    const auto region = region_at(hole_seeds[i]);
    assert(region);
    if (*region == kUnbounded) {
      ignored_seeds_.push_back(i);
    } else {
      where_[*region] = Where::kHole;
    }
  }
}

std::size_t Regions::in_front_of(const OrientedFacet& wall) const {
  return region_of_side_[2 * walls_->place_of(wall.vertices) + (wall.reversed ? 1 : 0)];
}

std::optional<std::size_t> Regions::region_at(const Point& point) const {
  if (walls_->size() == 0) return kUnbounded;
  if (!walls_->at(point).empty()) return std::nullopt;
  // On a way to a wall, with a bend as in wall_sides.hpp, the first wall that is met faces the
  // point.
  const Point target = walls_->centre(walls_->not_far_from(point));
  for (int t = 1;; ++t) {
    const Point by = bend(point, target, t);
    auto crossed = walls_->crossings(point, by);
    if (crossed && crossed->empty()) crossed = walls_->crossings(by, target);
    if (!crossed) continue;
    const Crossing& first = crossed->front();
    return region_of_side_[2 * first.wall + (first.from_front ? 0 : 1)];
  }
}

Where Regions::locate(const Point& point) const {
  const auto region = region_at(point);
  if (!region) return Where::kOnWall;
  if (kind_ == DomainKind::kHull && *region == kUnbounded && !is_in_hull(point)) {
    return Where::kOutside;
  }
  return where_[*region];
}

// Is it a convex combination of the points?
bool Regions::is_in_hull(const Point& point) const {
  LinearProgram program;
  program.equations.assign(point.size() + 1, {});
  program.right_sides = point;
  program.right_sides.emplace_back(1);
  for (const Point& p : *hull_of_) {
    for (std::size_t axis = 0; axis < p.size(); ++axis) program.equations[axis].push_back(p[axis]);
    program.equations.back().emplace_back(1);
  }
  program.objective.assign(hull_of_->size(), 0);
  return maximize(program).status != LinearProgramStatus::kInfeasible;
}

}  // namespace circumspect
