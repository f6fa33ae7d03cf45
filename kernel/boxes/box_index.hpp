// Boxes of doubles around exact points, and an R-tree of them: a filter, and the only doubles that
// the reference computes with. Cells whose boxes are disjoint are disjoint; boxes that meet prove
// nothing. They are here for speed alone: without boxes `build steiner-cdt` takes 70 to 190 %
// longer on landscapes of 200 to 350 polygons. Their index saves nothing there; on a surface of
// 20,000 triangles `validated` takes five times as long without it.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "kernel/boxes/interval.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect {

// A closed box whose edges are cut off: the least and the greatest value of x, y, z, x ± y, x ± z
// and y ± z. Long oblique cells that pass each other have axis-parallel boxes that meet, but seldom
// boxes of this kind that do. (J. Klosowski et al., "Efficient collision detection using bounding
// volume hierarchies of k-DOPs", IEEE Trans. Vis. Comput. Graph. 4, 1998.) In the plane z is 0.
struct Box {
  std::array<double, 9> low;
  std::array<double, 9> high;
};

// A box that holds the point: the values rounded outward. Requires: two or three coordinates.
Box box_around(const Point& point);

// The smallest box that holds both: if either holds a point, so does it, and it holds the convex
// hull of all points that they hold.
Box box_around(const Box& a, const Box& b);

// A box that holds the convex hull of some points. Requires: not empty.
Box box_around_all(const std::vector<Point>& points);

// A box that holds all points whose coordinates differ from the centre's by the reach or less.
Box cube(const Point& centre, const Rational& reach);

// Do the boxes overlap in all their values? True if they have a point in common.
bool may_meet(const Box& a, const Box& b);

// The same where only interior points of a cell matter, and `around` is a box around the cell: a
// value that is not constant on the cell takes neither its least nor its greatest value in the
// interior. Cells whose boxes only touch may meet, but not in interior points.
bool may_meet_inside(const Box& around, const Box& other);

// The work is that of Boost.Geometry's R-tree, packed once, on three axes. Its coordinates are
// doubles, which a filter may use: boxes are rounded outward, and exact predicates judge what a
// query finds.
class BoxIndex {
 public:
  explicit BoxIndex(const std::vector<Box>& boxes);
  ~BoxIndex();
  BoxIndex(BoxIndex&&) noexcept;
  BoxIndex& operator=(BoxIndex&&) noexcept;

  // The places in the list of all boxes that may meet this one, ascending.
  std::vector<std::size_t> meeting(const Box& box) const;

  // A box that is near this one: a good guess, not certainly the nearest. Requires: there is a box.
  std::size_t near(const Box& box) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace circumspect
