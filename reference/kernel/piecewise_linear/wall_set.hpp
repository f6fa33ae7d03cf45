// The walls of a complex, and where points and straight lines meet them.
// Book: Section 4.5.2 ("A linear cell in P that intersects the relative interior of xy but does not
// include xy occludes the visibility between x and y").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reference/kernel/piecewise_linear/cell_index.hpp"

namespace circumspect {

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
  // point, or lies in the hyperplane of a wall that it comes near to.
  std::optional<std::vector<Crossing>> crossings(const Point& from, const Point& to) const;

  // The same, for some walls at the vertex `apex` (space only), each made longer without end: the
  // cone over it, seen from the apex.
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

}  // namespace circumspect
