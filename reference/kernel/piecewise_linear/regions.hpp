// The polyhedra of a piecewise linear complex: the components of the complement of its walls.
// Book: Section 4.5.1 ("the underlying space … the domain to be triangulated").
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "reference/kernel/complex/facets.hpp"
#include "reference/kernel/piecewise_linear/nearby_cells.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/kernel/piecewise_linear/wall_set.hpp"

namespace circumspect {

// In which part of the plane or of space a point is.
enum class Where { kOnWall, kInside, kHole, kOutside };

// A value: copies share what has been computed, and nothing needs to outlive it.
class Regions {
 public:
  // Walls are (d−1)-simplices (see `walls`) that meet in common faces or not at all, each once.
  // Requires: no hole seed lies on a wall, unless the kind is kHull, which has no holes.
  Regions(const PointSet& points, const std::vector<Simplex>& walls,
          const std::vector<Point>& hole_seeds, DomainKind kind);
  explicit Regions(const PiecewiseLinearComplex& complex);

  // How many regions there are, the unbounded one among them, and what each is: never kOnWall.
  // Without a wall there is the unbounded one alone. In the hull kind it is inside (what there is
  // of it within the hull), unless all points lie in one hyperplane: then nothing is inside.
  std::size_t size() const { return where_.size(); }
  Where where(std::size_t region) const { return where_[region]; }
  static constexpr std::size_t kUnbounded = 0;

  // The region in front of a wall (its back: of wall.reverse()). Requires: it is a wall.
  std::size_t in_front_of(const OrientedFacet& wall) const;

  // Where a point is; the region of it, if it is on no wall. (Hull kind: what is beyond the convex
  // hull is outside, though no wall be there; points of the hull's boundary are inside.)
  Where locate(const Point& point) const;
  // The region that a point is in, nothing if it is on a wall.
  std::optional<std::size_t> region_at(const Point& point) const;

  // The hole seeds, by their places in the list, that make no hole: those in the unbounded region;
  // in the hull kind all of them.
  const std::vector<std::size_t>& ignored_seeds() const { return ignored_seeds_; }

  // The same, of which some bounded regions are holes.
  Regions with_holes(const std::vector<std::size_t>& regions) const {
    Regions other = *this;
    for (const std::size_t region : regions) other.where_[region] = Where::kHole;
    return other;
  }

  const WallSet& walls() const { return *walls_; }
  const NearbyCells& cells() const { return *cells_; }

 private:
  Regions(const PointSet& points, const std::vector<Simplex>& walls,
          const std::vector<Simplex>& segments, const std::vector<Point>& hole_seeds,
          DomainKind kind);
  void make_holes(const std::vector<Point>& hole_seeds);
  bool is_in_hull(const Point& point) const;

  DomainKind kind_;
  std::shared_ptr<const WallSet> walls_;
  std::shared_ptr<const NearbyCells> cells_;
  std::shared_ptr<const std::vector<Point>> hull_of_;  // hull kind only
  std::vector<std::size_t> region_of_side_;
  std::vector<Where> where_;
  std::vector<std::size_t> ignored_seeds_;
};

}  // namespace circumspect
