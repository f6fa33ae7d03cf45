// The walls of a complex, and the regions into which they cut the plane or space. Book: Section
// 4.5.1.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// The walls of a complex, and where points and straight lines meet them.
// Book: Section 4.5.2 ("A linear cell in P that intersects the relative interior of xy but does not
// include xy occludes the visibility between x and y").

// A directed line segment crosses a wall at its start (0), its end (1) or in between.
struct Crossing {
  Rational at;
  std::size_t wall;
  bool from_front;  // from the wall's front to its back?
};

// Walls are (d−1)-simplices that meet in common faces or not at all. The front of a wall is that of
// the oriented facet with its vertices in ascending order.
class WallSet {
 public:
  WallSet(const PointSet& points, std::vector<Simplex> walls);

  // With vertices ascending, in lexicographic order.
  const std::vector<Simplex>& simplices() const { return walls_; }
  std::size_t size() const { return walls_.size(); }
  // Requires: it is a wall; its vertices ascending.
  std::size_t place_of(const Simplex& wall) const;

  Point centre(std::size_t wall) const { return barycentre(corners(wall)); }
  std::vector<Point> corners(std::size_t wall) const;
  const Point& point(Vertex v) const { return points_[static_cast<std::size_t>(v)]; }

  // Positive if the point is in front of the wall, zero if it lies in its hyperplane.
  int side_of(std::size_t wall, const Point& point) const;

  // Walls that may meet a box, or a line segment; all walls that contain a point; some wall not far
  // from it.
  std::vector<std::size_t> near(const Box& box) const { return index_.meeting(box); }
  std::vector<std::size_t> near(const Point& from, const Point& to) const {
    return near_line(index_, from, to);
  }
  std::vector<std::size_t> at(const Point& point) const;
  std::size_t not_far_from(const Point& point) const { return index_.near(box_around(point)); }

  // Where a segment crosses walls, from its start to its end; nothing if it meets a wall otherwise
  // than by crossing it from one side to the other (or starting or ending there) in an interior
  // point, or lies in the hyperplane of a wall that it comes near.
  std::optional<std::vector<Crossing>> crossings(const Point& from, const Point& to) const;

  // How far one can go from a point in the interior of a wall without meeting another wall, as a
  // fraction of the way that is halved until this holds; nothing if the way lies in the hyperplane
  // of a wall that it comes near.
  std::optional<Rational> free_part(const Point& from, const Point& way) const;

  // The same as `crossings`, for some walls at the vertex `apex` (space only), each made longer
  // without end: the cone over it, seen from the apex.
  std::optional<std::vector<Crossing>> cone_crossings(Vertex apex,
                                                      std::span<const std::size_t> walls,
                                                      const Point& from, const Point& to) const;

 private:
  enum class Meeting { kNone, kInside, kBoundary };

  Meeting place_in(std::size_t wall, const Point& point, std::optional<Vertex> apex) const;
  std::optional<std::vector<Crossing>> crossings(std::span<const std::size_t> walls,
                                                 const Point& from, const Point& to,
                                                 std::optional<Vertex> apex) const;
  Rational height(std::size_t wall, const Point& point) const;
  Point normal(std::size_t wall) const;

  std::vector<Point> points_;
  std::vector<Simplex> walls_;
  BoxIndex index_;
};

// The polyhedra of a piecewise linear complex: the components of the complement of its walls.
// Book: Section 4.5.1 ("the underlying space … the domain to be triangulated").

// In which part of the plane or of space a point is.
enum class Where { kOnWall, kInside, kHole, kOutside };

// It has value semantics: copies share what has been computed, and nothing needs to outlive it.
class Regions {
 public:
  // Walls are (d−1)-simplices (see `walls`) that meet in common faces or not at all, each once.
  // Requires: no hole seed lies on a wall, unless the kind is kHull, which has no holes.
  Regions(const PointSet& points, const std::vector<Simplex>& walls,
          const std::vector<Point>& hole_seeds, DomainKind kind);
  explicit Regions(const PiecewiseLinearComplex& complex)
      : Regions(complex, complex.hole_seeds, complex.kind) {}
  // With other hole seeds and another kind than those of the complex.
  Regions(const PiecewiseLinearComplex& complex, const std::vector<Point>& hole_seeds,
          DomainKind kind);

  // The number of regions, including the unbounded one, and what each is: never kOnWall. Without
  // walls, the unbounded region is the only one. In the hull kind it is inside (its part within the
  // hull), unless all points lie in one hyperplane: then nothing is inside.
  std::size_t size() const { return where_.size(); }
  Where where(std::size_t region) const { return where_[region]; }
  static constexpr std::size_t kUnbounded = 0;

  // The region in front of a wall (its back: of wall.reverse()). Requires: it is a wall.
  std::size_t in_front_of(const OrientedFacet& wall) const;
  // Is that region inside? Requires: it is a wall.
  bool faces_inside(const OrientedFacet& wall) const {
    return where(in_front_of(wall)) == Where::kInside;
  }
  // The regions behind and in front of a wall, by its place among all walls.
  std::array<std::size_t, 2> beside(std::size_t wall) const {
    return {region_of_side_[2 * wall + 1], region_of_side_[2 * wall]};
  }

  // Where a point is; the region of it, if it is on no wall. (Hull kind: points beyond the convex
  // hull are outside, even where there is no wall; points of the hull's boundary are inside.)
  Where locate(const Point& point) const;
  // The region that contains a point; nothing if the point is on a wall.
  std::optional<std::size_t> region_at(const Point& point) const;

  // The hole seeds, by their places in the list, that make no hole: those in the unbounded region;
  // in the hull kind all of them.
  const std::vector<std::size_t>& ignored_seeds() const { return ignored_seeds_; }

  // The same regions, with some bounded ones as holes.
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
