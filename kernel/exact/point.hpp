// Points with exact rational coordinates, of any dimension, and their affine hulls.
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/exact/number.hpp"

namespace circumspect {

// Cartesian coordinates. std::vector's operator< is the lexicographic order of the perturbation.
using Point = std::vector<Rational>;

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
Point operator*(const Rational& factor, const Point& a);
Rational inner_product(const Point& a, const Point& b);
// Requires: three coordinates each.
Point cross_product(const Point& a, const Point& b);
// In a coordinate plane: a_x b_y − a_y b_x, twice the signed area of the triangle 0ab projected on
// the axes x and y.
Rational cross_product(const Point& a, const Point& b, std::size_t x, std::size_t y);
Rational squared_length(const Point& a);
Rational squared_distance(const Point& a, const Point& b);
// Of a point and the segment ab. Requires: a ≠ b.
Rational squared_distance_to_segment(const Point& p, const Point& a, const Point& b);
// The axis on which the vector is longest, the first of them. Requires: a coordinate.
std::size_t longest_axis(const Point& a);

// The arithmetic mean of the vertices of a simplex, a point of its relative interior.
// Requires: points is not empty, all of one dimension.
Point barycentre(const std::vector<Point>& points);

// The affine hull of some points. Book: Section 4.1 ("if the affine hull of S is k-dimensional …").
// `basis` holds the indices of k+1 affinely independent points, the
// first such in the order given. `axes` holds k coordinate axes, ascending, such that dropping all
// other coordinates is injective on the hull: a coordinate system of it.
struct AffineHull {
  int dimension = -1;  // k; -1 for no point at all
  std::vector<std::size_t> basis;
  std::vector<std::size_t> axes;
};

// Requires: all points of one dimension.
AffineHull affine_hull(const std::vector<Point>& points);

}  // namespace circumspect
