// Triangulations with many facets that are not locally Delaunay: grids, each cube cut alike, whose inner
// points are moved a little, and get weights.
#pragma once

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

// `side` points along each axis, two at least; coordinates and weights are doubles. By no more than
// `steps` / 1024 each coordinate moves: up to 50 keep every simplex as it is oriented.
inline ExactMesh shaken_grid(std::size_t dimension, std::size_t side, bool weighted,
                             long steps = 50) {
  std::mt19937 random(7);
  const auto draw = [&random](long most) {
    return static_cast<long>(random() % static_cast<unsigned long>(2 * most + 1)) - most;
  };
  std::vector<std::size_t> stride(dimension, 1);
  for (std::size_t axis = 1; axis < dimension; ++axis) stride[axis] = stride[axis - 1] * side;
  std::vector<Point> points;
  std::vector<Rational> weights;
  std::vector<Simplex> simplices;
  for (std::size_t v = 0; v < stride.back() * side; ++v) {
    Point point;
    bool is_inner = true, is_corner = true;
    for (const std::size_t step : stride) {
      const std::size_t place = v / step % side;
      point.push_back(static_cast<long>(place));
      is_inner &= place > 0 && place + 1 < side;
      is_corner &= place + 1 < side;
    }
    for (Rational& coordinate : point) {
      if (is_inner) coordinate += Rational(draw(steps)) / 1024;
    }
    points.push_back(point);
    if (weighted) weights.push_back(Rational(draw(100)) / 1024);
    if (!is_corner) continue;
    std::vector<std::size_t> order = stride;
    do {
      Simplex simplex = {static_cast<Vertex>(v)};
      for (const std::size_t step : order) {
        simplex.push_back(simplex.back() + static_cast<Vertex>(step));
      }
      simplices.push_back(std::move(simplex));
    } while (std::next_permutation(order.begin(), order.end()));
  }
  // In no particular order.
  std::shuffle(simplices.begin(), simplices.end(), random);
  return {PointSet(std::move(points), std::move(weights)), std::move(simplices)};
}

}  // namespace circumspect::check
