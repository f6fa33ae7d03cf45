// Boxes of doubles around exact points, and an R-tree of them: a filter, and the only doubles that
// the reference computes with. Cells whose boxes are disjoint are disjoint; of others nothing is
// concluded. They are here for speed alone: without boxes `build steiner-cdt` takes 70 to 190 %
// longer on landscapes of 200 to 350 polygons. Their index saves nothing there; on a surface of
// 20,000 triangles `validated` takes five times as long without it.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect {

// The largest double that is at most the value and the smallest that is at least the value; −∞ and
// +∞ count as doubles.
double lower_double(const Rational& value);
double upper_double(const Rational& value);

// A closed box whose edges are cut off: the least and the greatest value of x, y, z, x ± y, x ± z
// and y ± z. Long cells that run aslant past each other meet in their axis-parallel boxes and
// seldom in these. (J. Klosowski et al., "Efficient collision detection using bounding volume
// hierarchies of k-DOPs", IEEE Trans. Vis. Comput. Graph. 4, 1998.) In the plane z is 0.
struct Box {
  std::array<double, 9> low;
  std::array<double, 9> high;
};

// A box that holds the point: the values rounded outward. Requires: two or three coordinates.
Box box_around(const Point& point);

// The smallest box that holds both: if either holds a point, so does it, and it holds the convex
// hull of all points that they hold.
Box box_around(const Box& a, const Box& b);

// A box that holds all points whose coordinates differ from the centre's by the reach or less.
Box cube(const Point& centre, const Rational& reach);

// Have the boxes a point in common, as far as their values say? True if they have.
bool may_meet(const Box& a, const Box& b);

// The same where only points inside of a cell matter, off its boundary, and `around` is a box around it: a value that
// differs between points of the cell has neither its least nor its greatest there. Boxes that only touch may meet,
// but not inside.
bool may_meet_inside(const Box& around, const Box& other);

// The work is that of Boost.Geometry's R-tree, packed once, on three axes. It has doubles for
// coordinates, which a filter may have: boxes are rounded outward, and what a query finds is judged
// by exact predicates.
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
