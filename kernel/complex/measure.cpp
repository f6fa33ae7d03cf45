#include "kernel/complex/measure.hpp"

#include "kernel/predicates/orientation.hpp"

namespace circumspect {

Rational measure(const PointSet& points, std::span<const std::size_t> axes,
                 const Simplex& simplex) {
  return abs(orientation_determinant(points.configuration(), axes, simplex));
}

Rational measure(const PointSet& points, std::span<const std::size_t> axes,
                 const std::vector<Simplex>& simplices) {
  Rational sum = 0;
  for (const Simplex& simplex : simplices) sum += measure(points, axes, simplex);
  return sum;
}

}  // namespace circumspect
