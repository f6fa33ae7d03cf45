#include "kernel/complex/circumball.hpp"

#include <cassert>

#include "kernel/exact/linear_algebra.hpp"

namespace circumspect {

Ball circumball(const PointSet& points, const Simplex& simplex) {
  assert(!simplex.empty());
  const Vertex first = simplex.front();
  const std::size_t k = simplex.size() - 1;
  std::vector<Point> edges;
  for (std::size_t i = 1; i <= k; ++i) edges.push_back(points[simplex[i]] - points[first]);
  // The centre is p_0 + Σ t_j e_j with 2 e_i·(centre − p_0) = |e_i|² − w_i + w_0 for every edge.
  RationalMatrix gram(k, std::vector<Rational>(k));
  std::vector<Rational> right(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) gram[i][j] = 2 * inner_product(edges[i], edges[j]);
    right[i] = squared_length(edges[i]) - points.weight(simplex[i + 1]) + points.weight(first);
  }
  const auto t = solve(gram, right);
  assert(t.has_value());
  Ball ball{points[first], 0};
  for (std::size_t j = 0; j < k; ++j) ball.centre = ball.centre + (*t)[j] * edges[j];
  ball.squared_radius = squared_distance(points[first], ball.centre) - points.weight(first);
  return ball;
}

Rational power(const PointSet& points, const Ball& ball, Vertex q) {
  return squared_distance(points[q], ball.centre) - points.weight(q) - ball.squared_radius;
}

}  // namespace circumspect
