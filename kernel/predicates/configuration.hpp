// A point configuration: finitely many labelled points, scaled to integers so that every predicate
// is the sign of an integer determinant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect {

// The index of a point in its configuration, counted from 0.
using Vertex = std::int64_t;

// Point v is stored as integers X_1 … X_d over a positive denominator W, and its height
// |p|² − weight as an integer H over W². One common W serves all points whenever it has at most
// kLargestCommonScale bits, which holds for every set of doubles; points whose denominators have
// little in common (rational points on a sphere) keep their own, because a common one would square
// the size of the input. Both forms give the same signs.
class Configuration {
 public:
  // Requires: points all have one dimension; weights is empty (all zero) or as long as points.
  explicit Configuration(const std::vector<Point>& points,
                         const std::vector<Rational>& weights = {});

  std::size_t size() const { return denominators_.size(); }
  // The number of coordinates, d.
  std::size_t ambient_dimension() const { return ambient_dimension_; }
  // The affine hull of all points: its dimension k, k+1 independent vertices, k axes.
  const AffineHull& hull() const { return hull_; }
  int dimension() const { return hull_.dimension; }
  std::span<const std::size_t> axes() const { return hull_.axes; }

  const Integer& numerator(Vertex v, std::size_t axis) const {
    return numerators_[static_cast<std::size_t>(v) * ambient_dimension_ + axis];
  }
  const Integer& denominator(Vertex v) const { return denominators_[static_cast<std::size_t>(v)]; }
  // The numerator H of the height |p|² − weight, over denominator(v)².
  const Integer& height(Vertex v) const { return heights_[static_cast<std::size_t>(v)]; }
  bool has_common_denominator() const { return has_common_denominator_; }

  // The place of v in the lexicographic order of the points, counted from 0; duplicates, which a
  // point set never has, would be ranked by index.
  std::size_t rank(Vertex v) const { return ranks_[static_cast<std::size_t>(v)]; }

  static constexpr std::size_t kLargestCommonScale = 2400;

 private:
  void scale_to_integers(const std::vector<Point>& points, const std::vector<Rational>& weights);
  void choose_denominators(const std::vector<Point>& points, const std::vector<Rational>& weights);

  std::size_t ambient_dimension_ = 0;
  AffineHull hull_;
  std::vector<Integer> numerators_;
  std::vector<Integer> denominators_;
  std::vector<Integer> heights_;
  std::vector<std::size_t> ranks_;
  bool has_common_denominator_ = true;
};

}  // namespace circumspect
