#include "reference/optimality/barycentric.hpp"

#include <algorithm>
#include <cassert>

#include "reference/kernel/exact/linear_system.hpp"

namespace circumspect::optimality {
namespace {

// p − v_0 − Σ t_i e_i is orthogonal to every edge e_i = v_i − v_0; nothing if the edges are
// dependent.
std::optional<std::vector<Rational>> projection(const PointSet& points, const Simplex& simplex,
                                                const Point& p) {
  assert(!simplex.empty());
  const Point& origin = points[simplex.front()];
  const std::size_t k = simplex.size() - 1;
  std::vector<Point> edges;
  for (std::size_t i = 1; i <= k; ++i) edges.push_back(points[simplex[i]] - origin);
  RationalMatrix gram(k, std::vector<Rational>(k));
  std::vector<Rational> right(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) gram[i][j] = inner_product(edges[i], edges[j]);
    right[i] = inner_product(edges[i], p - origin);
  }
  std::optional<std::vector<Rational>> coefficients = solve(gram, right);
  if (!coefficients) return std::nullopt;
  Rational first = 1;
  for (const Rational& t : *coefficients) first -= t;
  coefficients->insert(coefficients->begin(), first);
  return coefficients;
}

}  // namespace

std::optional<std::vector<Rational>> barycentric_coordinates(const PointSet& points,
                                                             const Simplex& simplex,
                                                             const Point& p) {
  auto coefficients = projection(points, simplex, p);
  if (coefficients && combination(points, simplex, *coefficients) != p) return std::nullopt;
  return coefficients;
}

std::vector<Rational> coordinates_of_projection(const PointSet& points, const Simplex& simplex,
                                                const Point& p) {
  auto coefficients = projection(points, simplex, p);
  assert(coefficients.has_value());
  return *coefficients;
}

Point combination(const PointSet& points, const Simplex& simplex,
                  const std::vector<Rational>& coefficients) {
  assert(simplex.size() == coefficients.size());
  Point sum(points.ambient_dimension(), Rational(0));
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    sum = sum + coefficients[i] * points[simplex[i]];
  }
  return sum;
}

bool is_convex(const std::vector<Rational>& coefficients) {
  return std::all_of(coefficients.begin(), coefficients.end(),
                     [](const Rational& coefficient) { return sign(coefficient) >= 0; });
}

}  // namespace circumspect::optimality
