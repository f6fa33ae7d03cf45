#include "oracle/judge/fast/reference_signs_test.hpp"

#include <utility>

#include <doctest/doctest.h>

#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/kernel/predicates/orientation.hpp"
#include "reference/kernel/predicates/perturbation.hpp"

namespace circumspect::fast {

struct ReferenceSigns::Exact {
  Configuration points;
  std::vector<std::size_t> axes;
};

ReferenceSigns::ReferenceSigns(const std::vector<std::vector<double>>& points,
                               const std::vector<double>& weights) {
  std::vector<Point> exact;
  std::vector<Rational> exact_weights;
  for (const auto& point : points) {
    exact.emplace_back();
    for (const double x : point) exact.back().push_back(exact_value(x));
  }
  for (const double weight : weights) exact_weights.push_back(exact_value(weight));
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < points.front().size(); ++axis) axes.push_back(axis);
  exact_ = std::make_unique<Exact>(Exact{Configuration(exact, exact_weights), axes});
}

ReferenceSigns::~ReferenceSigns() = default;

int ReferenceSigns::orientation(const Vertices& simplex) const {
  return circumspect::orientation(exact_->points, exact_->axes, simplex);
}

int ReferenceSigns::ball(const Vertices& vertices) const {
  for (std::size_t swapped = vertices.size(); swapped-- > 0;) {
    const bool last = swapped + 1 == vertices.size();
    Vertices simplex = vertices;
    std::swap(simplex[swapped], simplex.back());
    const Vertex query = simplex.back();
    simplex.pop_back();
    const int oriented = orientation(simplex);
    if (oriented == 0) continue;
    const int inside = in_ball(exact_->points, exact_->axes, simplex, query);
    return inside * oriented * (last ? 1 : -1);
  }
  return 0;
}

int ReferenceSigns::perturbed_ball(const Vertices& vertices) const {
  const Vertices simplex(vertices.begin(), vertices.end() - 1);
  return perturbed_in_ball(exact_->points, exact_->axes, simplex, vertices.back());
}

namespace {

TEST_CASE(
    "reference signs: swapping two of the vertices negates the ball's, "
    "degenerate or not") {
  const ReferenceSigns signs({{0, 0}, {1, 0}, {2, 0}, {0, 3}, {3, 0}}, {});
  CHECK(signs.orientation({0, 1, 3}) == 1);
  CHECK(signs.ball({0, 1, 3, 2}) == -1);
  CHECK(signs.ball({0, 1, 2, 3}) == 1);
  CHECK(signs.ball({0, 3, 2, 1}) == -signs.ball({0, 1, 2, 3}));
  CHECK(signs.ball({0, 1, 2, 4}) == 0);
}

}  // namespace
}  // namespace circumspect::fast
