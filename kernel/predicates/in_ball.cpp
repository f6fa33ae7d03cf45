#include "kernel/predicates/in_ball.hpp"

#include <cassert>

#include "kernel/predicates/orientation.hpp"

namespace circumspect {
namespace {

// Row p⁺ − q⁺ of the lifted determinant, scaled to integers by a positive factor: by W² if both
// points have denominator W, else by (W V)².
void lifted_row(const Configuration& points, std::span<const std::size_t> axes, Vertex p, Vertex q,
                SquareMatrix& matrix, std::size_t row) {
  const std::size_t k = axes.size();
  if (points.has_common_denominator()) {
    // With one denominator W in the whole matrix, columns may be scaled instead: by W all
    // coordinates, by W² the heights.
    for (std::size_t j = 0; j < k; ++j) {
      matrix(row, j) = points.numerator(p, axes[j]) - points.numerator(q, axes[j]);
    }
    matrix(row, k) = points.height(p) - points.height(q);
    return;
  }
  const Integer& w = points.denominator(p);
  const Integer& v = points.denominator(q);
  const Integer both = w * v;
  for (std::size_t j = 0; j < k; ++j) {
    matrix(row, j) = (points.numerator(p, axes[j]) * v - points.numerator(q, axes[j]) * w) * both;
  }
  matrix(row, k) = points.height(p) * v * v - points.height(q) * w * w;
}

}  // namespace

int in_ball(const Configuration& points, std::span<const std::size_t> axes,
            std::span<const Vertex> simplex, Vertex q) {
  assert(simplex.size() == axes.size() + 1);
  SquareMatrix lifted(simplex.size());
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    lifted_row(points, axes, simplex[i], q, lifted, i);
  }
  const int side = sign(determinant(std::move(lifted)));
  return side == 0 ? 0 : side * orientation(points, axes, simplex);
}

int in_ball(const Configuration& points, std::span<const Vertex> simplex, Vertex q) {
  return in_ball(points, points.axes(), simplex, q);
}

}  // namespace circumspect
