#include "oracle/judge/domain/measures.hpp"

#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {

Rational measure(const PointSet& points, const Axes& axes, const Simplex& simplex) {
  return abs(orientation_determinant(points.configuration(), axes, simplex));
}

Rational measure(const PointSet& points, const Axes& axes, const std::vector<Simplex>& simplices) {
  Rational sum = 0;
  for (const Simplex& simplex : simplices) sum += measure(points, axes, simplex);
  return sum;
}

}  // namespace circumspect::check
