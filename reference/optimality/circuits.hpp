// The circuits of a point set: its minimal affinely dependent subsets. Book: Section 4.4, the
// vertex sets W of (lower-dimensional) basic flips.
#pragma once

#include <vector>

#include "reference/complex/point_set.hpp"

namespace circumspect::optimality {

// The points of both parts are affinely dependent, those of no proper subset are. The sign says on
// which side of the one dependence a point stands: the two parts are what Radon's theorem divides
// the set into, conv(positive) meets conv(negative) in one point.
struct Circuit {
  Simplex positive;  // ascending
  Simplex negative;  // ascending
};

// All circuits, each once; which part is called positive is arbitrary.
std::vector<Circuit> circuits(const PointSet& points);

}  // namespace circumspect::optimality
