#include "oracle/judge/definition/distance.hpp"

#include <algorithm>
#include <optional>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/linear_algebra.hpp"

namespace circumspect::definition {
namespace {

using Points = std::vector<Point>;

// The squared distance between the affine hulls of some points, if one pair of points is nearest
// and lies in the simplices. These are a_0 + Σ s_i u_i and b_0 + Σ t_j w_j, with their difference
// at right angles to all u_i and w_j.
std::optional<Rational> squared_distance_inside(const Points& a, const Points& b) {
  Points directions;
  for (std::size_t i = 1; i < a.size(); ++i) directions.push_back(a[i] - a[0]);
  for (std::size_t j = 1; j < b.size(); ++j) directions.push_back(b[0] - b[j]);
  Point difference = a[0] - b[0];
  RationalMatrix products;
  std::vector<Rational> right;
  for (const Point& u : directions) {
    products.emplace_back();
    for (const Point& w : directions) products.back().push_back(inner_product(u, w));
    right.push_back(-inner_product(u, difference));
  }
  const auto factors = solve(products, right);
  if (!factors) return std::nullopt;
  Rational rest_of_a = 1, rest_of_b = 1;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Rational& factor = (*factors)[i];
    if (sign(factor) < 0) return std::nullopt;
    difference = difference + factor * directions[i];
    (i + 1 < a.size() ? rest_of_a : rest_of_b) -= factor;
  }
  if (sign(rest_of_a) < 0 || sign(rest_of_b) < 0) return std::nullopt;
  return squared_length(difference);
}

// Calls `visit` with the simplices of some points, of d dimensions or fewer, until it returns
// false.
template <class Visit>
bool visit_simplices_of(const Points& points, const Visit& visit) {
  const std::size_t most = std::min(points.size(), points.front().size() + 1);
  for (std::size_t size = 1; size <= most; ++size) {
    Simplex places = first_subset(size);
    do {
      Points corners;
      for (const Vertex i : places) corners.push_back(points[static_cast<std::size_t>(i)]);
      if (!visit(corners)) return false;
    } while (next_subset(places, points.size()));
  }
  return true;
}

}  // namespace

// The search ends at 0, since no distance is less.
Rational squared_distance_between(const Points& a, const Points& b) {
  std::optional<Rational> least;
  visit_simplices_of(a, [&](const Points& of_a) {
    return visit_simplices_of(b, [&](const Points& of_b) {
      const auto squared = squared_distance_inside(of_a, of_b);
      if (squared && (!least || *squared < *least)) least = squared;
      return !least || sign(*least) > 0;
    });
  });
  return *least;
}

}  // namespace circumspect::definition
