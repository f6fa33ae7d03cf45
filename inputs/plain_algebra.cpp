#include "inputs/plain_algebra.hpp"

#include <algorithm>
#include <numeric>

namespace circumspect::generators {
namespace {

bool has_minor(const std::vector<Point>& rows, std::size_t order) {
  const auto column_sets = subsets(rows.front().size(), order);
  for (const auto& row_set : subsets(rows.size(), order)) {
    std::vector<Point> some_rows;
    for (const std::size_t row : row_set) some_rows.push_back(rows[row]);
    for (const auto& columns : column_sets) {
      if (sign(leibniz_determinant(projected(some_rows, columns))) != 0) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::vector<std::size_t>> subsets(std::size_t n, std::size_t k) {
  std::vector<bool> chosen(n, false);
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(k), true);
  std::vector<std::vector<std::size_t>> all;
  do {
    std::vector<std::size_t> subset;
    for (std::size_t i = 0; i < n; ++i) {
      if (chosen[i]) subset.push_back(i);
    }
    all.push_back(subset);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return all;
}

Rational leibniz_determinant(const std::vector<Point>& rows) {
  std::vector<std::size_t> image(rows.size());
  std::iota(image.begin(), image.end(), std::size_t{0});
  Rational sum = 0;
  do {
    Rational product = 1;
    for (std::size_t i = 0; i < image.size() && sign(product) != 0; ++i) {
      product *= rows[i][image[i]];
      for (std::size_t j = 0; j < i; ++j) {
        if (image[j] > image[i]) product = -product;
      }
    }
    sum += product;
  } while (std::next_permutation(image.begin(), image.end()));
  return sum;
}

std::size_t rank_by_minors(const std::vector<Point>& rows) {
  if (rows.empty()) return 0;
  std::size_t rank = std::min(rows.size(), rows.front().size());
  while (rank > 0 && !has_minor(rows, rank)) --rank;
  return rank;
}

int dimension_by_minors(const std::vector<Point>& points) {
  std::vector<Point> rows;
  for (std::size_t i = 1; i < points.size(); ++i) rows.push_back(points[i] - points[0]);
  return points.empty() ? -1 : static_cast<int>(rank_by_minors(rows));
}

std::vector<Point> projected(const std::vector<Point>& points,
                             const std::vector<std::size_t>& axes) {
  std::vector<Point> images;
  for (const Point& point : points) {
    Point image;
    for (const std::size_t axis : axes) image.push_back(point[axis]);
    images.push_back(image);
  }
  return images;
}

Point cramer_solution(const std::vector<Point>& rows, const Point& right_hand_side) {
  const Rational determinant = leibniz_determinant(rows);
  Point solution;
  for (std::size_t column = 0; column < rows.size(); ++column) {
    std::vector<Point> replaced = rows;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      replaced[row][column] = right_hand_side[row];
    }
    solution.push_back(leibniz_determinant(replaced) / determinant);
  }
  return solution;
}

PowerBall power_ball(const std::vector<Point>& simplex, const std::vector<Rational>& weights) {
  const std::size_t k = simplex.size() - 1;
  std::vector<Point> gram(k, Point(k));
  Point right_hand_side(k);
  for (std::size_t i = 0; i < k; ++i) {
    const Point edge = simplex[i] - simplex[k];
    for (std::size_t j = 0; j < k; ++j) {
      gram[i][j] = 2 * inner_product(edge, simplex[j] - simplex[k]);
    }
    right_hand_side[i] = squared_length(edge) - weights[i] + weights[k];
  }
  const Point factors = cramer_solution(gram, right_hand_side);
  Point centre = simplex[k];
  for (std::size_t i = 0; i < k; ++i) centre = centre + factors[i] * (simplex[i] - simplex[k]);
  return {centre, squared_distance(centre, simplex[k]) - weights[k]};
}

}  // namespace circumspect::generators
