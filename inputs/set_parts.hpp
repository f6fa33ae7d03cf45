// What the families of point sets are made of.
#pragma once

#include <cstddef>
#include <vector>

#include <rapidcheck.h>

#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// 0 to max_count elements, all counts equally likely; max_count of them if RapidCheck's size is beyond
// the nominal one.
template <typename T>
rc::Gen<std::vector<T>> up_to(std::size_t max_count, const rc::Gen<T>& element) {
  const auto elements = rc::gen::resize(rc::kNominalSize, element);
  return rc::gen::withSize([=](int size) {
    if (size > rc::kNominalSize) return rc::gen::container<std::vector<T>>(max_count, elements);
    return rc::gen::resize(static_cast<int>(max_count),
                           rc::gen::container<std::vector<T>>(elements));
  });
}

rc::Gen<Point> point_of(std::size_t dimension, const rc::Gen<Rational>& coordinate);

// The points in the order given, each once.
std::vector<Point> distinct(const std::vector<Point>& points);

// Up to max_points points, each once.
PointSets sets_of(const rc::Gen<Point>& point, std::size_t max_points);

// The points of `sets`, which may have fewer coordinates, carried into R^dimension by a random
// similarity with integer coefficients.
PointSets carried(const PointSets& sets, std::size_t dimension);

// The point of the unit sphere in R^{n+1} that stereographic projection sends to `image` in R^n.
Point from_stereographic(const Point& image);

// The number of symmetries of the cube in R^d, d! · 2^d, and the image of a point under one of them: a
// permutation of the coordinates and a choice of signs. Requires: dimension <= 16.
long cube_symmetries(std::size_t dimension);
Point symmetric_image(const Point& point, long code);

}  // namespace circumspect::generators
