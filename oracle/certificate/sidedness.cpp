#include "oracle/certificate/sidedness.hpp"

#include <cassert>

namespace circumspect::certificate {

int Sidedness::sign_of_determinant() {
  const auto& [a, b, c] = rows_;
  if (points_.dimension == 2) {
    determinant_ = a[0] * b[1];
    subtract_product(determinant_, a[1], b[0]);
    return sign(determinant_);
  }
  determinant_ = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    minor_ = b[j] * c[k];
    subtract_product(minor_, b[k], c[j]);
    add_product(determinant_, a[i], minor_);
  }
  return sign(determinant_);
}

int Sidedness::orientation(std::span<const Vertex> simplex) {
  const std::size_t d = points_.dimension;
  assert(simplex.size() == d + 1);
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      rows_[i][axis] = points_.coordinate(simplex[i], axis) - points_.coordinate(simplex[d], axis);
    }
  }
  return sign_of_determinant();
}

int Sidedness::orientation_with(std::span<const Vertex> simplex, std::size_t place,
                                const HomogeneousPoint& q) {
  const std::size_t d = points_.dimension;
  assert(simplex.size() == d + 1);
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      Integer& entry = rows_[i][axis];
      const Integer& last = points_.coordinate(simplex[d], axis);
      if (i == place) {  // a row times the positive denominator
        entry = q.numerators[axis];
        subtract_product(entry, q.denominator, last);
      } else if (place == d) {
        entry = q.denominator * points_.coordinate(simplex[i], axis);
        entry -= q.numerators[axis];
      } else {
        entry = points_.coordinate(simplex[i], axis) - last;
      }
    }
  }
  return sign_of_determinant();
}

std::optional<std::size_t> Sidedness::separating_place(std::span<const Vertex> simplex, int own,
                                                       const HomogeneousPoint& q,
                                                       std::size_t first) {
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    const std::size_t place = (first + i) % simplex.size();
    if (orientation_with(simplex, place, q) * own < 0) return place;
  }
  return std::nullopt;
}

}  // namespace circumspect::certificate
