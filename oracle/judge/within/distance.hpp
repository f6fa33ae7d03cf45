// Exact squared distances between points, segments and triangles, and a filter that avoids most of
// them.
#pragma once

#include <span>
#include <vector>

#include "kernel/boxes/box_index.hpp"
#include "kernel/boxes/interval.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/exact/triple.hpp"

namespace circumspect::check {

// Of a point and a simplex of one to three corners, in the plane or in space.
// Requires: the corners are affinely independent.
Rational squared_distance_to(const std::vector<Point>& simplex, const Point& point);

// Of two simplices of one to three corners each. Requires: as above, and that they have no point in
// common; in the plane they are points or segments.
Rational squared_distance_between(const std::vector<Point>& a, const std::vector<Point>& b);

// What doubles know of a point. In the plane the third coordinate is 0.
using RoundedPoint = Triple<Interval>;
RoundedPoint rounded(const Point& point);

// At least the square root, and hardly more.
Rational upper_square_root(const Rational& squared);

// Points and distances in doubles. Where products of a few coordinates would not be doubles,
// everything is scaled by one power of two, so that the filters decide as much as they do
// elsewhere.
class Rounding {
 public:
  // For points like these.
  explicit Rounding(const std::vector<Point>& points);

  RoundedPoint point(const Point& point) const;
  RoundedPoint point(std::span<const double> point) const;
  std::vector<RoundedPoint> points(const std::vector<Point>& points) const;
  // At least the square root.
  double distance(const Rational& squared) const;

 private:
  long exponent_ = 0;  // of the power that everything is divided by
};

// A box that holds whatever is at most so far from one of the points, and from what is between
// them.
Box box_about(std::span<const RoundedPoint> points, double distance);

// True only if two simplices of one to three corners each are more than `distance` apart; false
// says nothing.
bool certainly_apart(std::span<const RoundedPoint> a, std::span<const RoundedPoint> b,
                     double distance);

}  // namespace circumspect::check
