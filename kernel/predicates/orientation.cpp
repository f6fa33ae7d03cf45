#include "kernel/predicates/orientation.hpp"

#include <cassert>

namespace circumspect {

namespace {

// Row i is p_i − p_k on the axes. With x/W − y/V in mind it is scaled by W·V > 0, or by W alone if
// all points have denominator W.
SquareMatrix difference_matrix(const Configuration& points, std::span<const std::size_t> axes,
                               std::span<const Vertex> simplex) {
  assert(simplex.size() == axes.size() + 1);
  const std::size_t k = axes.size();
  const Vertex last = simplex[k];
  SquareMatrix matrix(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      const Integer& x = points.numerator(simplex[i], axes[j]);
      const Integer& y = points.numerator(last, axes[j]);
      if (points.has_common_denominator()) {
        matrix(i, j) = x - y;
      } else {
        matrix(i, j) = x * points.denominator(last) - y * points.denominator(simplex[i]);
      }
    }
  }
  return matrix;
}

}  // namespace

int orientation(const Configuration& points, std::span<const std::size_t> axes,
                std::span<const Vertex> simplex) {
  return sign(determinant(difference_matrix(points, axes, simplex)));
}

Rational orientation_determinant(const Configuration& points, std::span<const std::size_t> axes,
                                 std::span<const Vertex> simplex) {
  Rational value(determinant(difference_matrix(points, axes, simplex)));
  for (std::size_t i = 0; i + 1 < simplex.size(); ++i) {
    value /= points.denominator(simplex[i]);
    if (!points.has_common_denominator()) value /= points.denominator(simplex.back());
  }
  return value;
}

int orientation(const Configuration& points, std::span<const Vertex> simplex) {
  return orientation(points, points.axes(), simplex);
}

int side_of_facet(const Configuration& points, std::span<const std::size_t> axes,
                  std::span<const Vertex> facet, Vertex q) {
  std::vector<Vertex> simplex(facet.begin(), facet.end());
  simplex.push_back(q);
  return orientation(points, axes, simplex);
}

int side_of_facet(const Configuration& points, std::span<const Vertex> facet, Vertex q) {
  return side_of_facet(points, points.axes(), facet, q);
}

int orientation_with(const Configuration& points, std::span<const std::size_t> axes,
                     std::span<const Vertex> simplex, std::size_t place, Vertex q) {
  std::vector<Vertex> replaced(simplex.begin(), simplex.end());
  replaced[place] = q;
  return orientation(points, axes, replaced);
}

std::vector<std::size_t> axes_of(const Configuration& points, std::span<const Vertex> simplex) {
  std::vector<Point> vertices;
  for (const Vertex v : simplex) {
    Point vertex;
    for (std::size_t axis = 0; axis < points.ambient_dimension(); ++axis) {
      Rational x(points.numerator(v, axis), points.denominator(v));
      x.canonicalize();
      vertex.push_back(x);
    }
    vertices.push_back(vertex);
  }
  return affine_hull(vertices).axes;
}

}  // namespace circumspect
