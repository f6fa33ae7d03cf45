// The polyhedra of a piecewise linear complex: the components of the complement of its walls.
// Book: Section 4.5.1 ("the underlying space … the domain to be triangulated").
#pragma once

#include <vector>

#include "reference/complex/oriented_facet.hpp"
#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// In which part of the plane or of space a point is.
enum class Where { kOnWall, kInside, kHole, kOutside };

class Regions {
 public:
  // Walls are (d−1)-simplices (see `walls`) that meet in common faces or not at all.
  Regions(const PointSet& points, const std::vector<Simplex>& walls,
          const std::vector<Point>& hole_seeds, DomainKind kind);
  explicit Regions(const PiecewiseLinearComplex& complex);

  // How many regions there are, the unbounded one among them, and what each is: never kOnWall.
  std::size_t size() const;
  Where where(std::size_t region) const;

  // The region in front of a wall (its back: of wall.reverse()). Requires: it is a wall.
  std::size_t in_front_of(const OrientedFacet& wall) const;

  // Where a point is; the region of it, if it is on no wall. (Hull kind: what is beyond the convex
  // hull is outside, though no wall be there; points of the hull's boundary are inside.)
  Where locate(const Point& point) const;
};

}  // namespace circumspect
