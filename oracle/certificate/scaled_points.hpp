// Points as integers over one scale, as small as they can be: what a certificate lists.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "reference/kernel/complex/point_set.hpp"

namespace circumspect::certificate {

// Ten gigabytes of digits make no file that anyone would keep.
inline constexpr double kMostBits = 3e10;

// The points are the integer points times P/Q, the weights the integer weights times (P/Q)².
struct ScaledPoints {
  std::size_t dimension = 0;  // the number of coordinates, d
  Integer scale_numerator = 1;
  Integer scale_denominator = 1;
  std::vector<Integer> coordinates = {};  // d a point
  std::vector<Integer> weights = {};      // empty, or one a point

  std::size_t size() const { return dimension == 0 ? 0 : coordinates.size() / dimension; }
  const Integer& coordinate(Vertex v, std::size_t axis) const {
    return coordinates[static_cast<std::size_t>(v) * dimension + axis];
  }
};

// Multiplies by the least common denominator of all coordinates and divides by what they have in
// common; both are positive. Weights may make the scale finer. Error: denominators that have so little
// in common that the coordinates may take more than `most_bits` together.
tl::expected<ScaledPoints, std::string> scaled_to_integers(const PointSet& points,
                                                           double most_bits = kMostBits);

// A point with rational coordinates among the integer points: numerators over a positive denominator.
struct HomogeneousPoint {
  std::vector<Integer> numerators;
  Integer denominator = 1;
};

// Divides by what numerators and denominator have in common.
HomogeneousPoint in_lowest_terms(HomogeneousPoint point);

// A point among the integer points. `point` is in the user's own coordinates.
HomogeneousPoint scaled(const ScaledPoints& points, const Point& point);

// The barycentre of some of the points. Requires: vertices is not empty.
HomogeneousPoint barycentre(const ScaledPoints& points, const Simplex& vertices);

}  // namespace circumspect::certificate
