// Meshes that a lattice repeats in every direction.
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect {

// The largest integer that is not larger.
inline Integer rounded_down(const Rational& value) {
  const Integer towards_zero = value.get_num() / value.get_den();
  return value < towards_zero ? Integer(towards_zero - 1) : towards_zero;
}

// How a program lists such a mesh, beside points and cells: each corner is a listed point that was
// moved by integer multiples of the vectors.
struct Periodic {
  std::vector<Point> lattice = {};    // d vectors of d numbers
  std::vector<Simplex> offsets = {};  // of each cell: d integers for each corner, corner by corner
};

// What the points of a mesh are if it has a point for each corner: copies of those that were
// listed. The listed points come first, as they are.
struct Copies {
  std::vector<Point> lattice = {};
  std::vector<Vertex> of = {};        // which listed point
  std::vector<Simplex> offsets = {};  // multiples of the vectors
  std::size_t listed = 0;

  // The sum of such multiples.
  Point shift(const Simplex& multiples) const {
    Point sum(lattice.size(), 0);
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      sum = sum + Rational(to_integer(multiples[i])) * lattice[i];
    }
    return sum;
  }
};

}  // namespace circumspect
