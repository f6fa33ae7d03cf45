// Points with exact rational coordinates, of any dimension.
#pragma once

#include <vector>

#include "reference/kernel/exact/number.hpp"

namespace circumspect {

// Cartesian coordinates. std::vector's operator< is the lexicographic order of the perturbation.
using Point = std::vector<Rational>;

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
Point operator*(const Rational& factor, const Point& a);
Rational inner_product(const Point& a, const Point& b);
Rational squared_length(const Point& a);
Rational squared_distance(const Point& a, const Point& b);

// The arithmetic mean of the vertices of a simplex, a point of its relative interior.
// Requires: points is not empty, all of one dimension.
Point barycentre(const std::vector<Point>& points);

}  // namespace circumspect
