#include "oracle/judge/voronoi/nearest_in_hull.hpp"

#include <algorithm>

#include "kernel/exact/linear_algebra.hpp"

namespace circumspect::check {
namespace {

// Differences from q, so that the nearest point is that of least length.
class LeastLength {
 public:
  LeastLength(const Point& q, const std::vector<Point>& points) {
    for (const Point& point : points) differences_.push_back(point - q);
  }

  Rational squared() {
    const auto is_shorter = [](const Point& a, const Point& b) {
      return squared_length(a) < squared_length(b);
    };
    corral_ = {*std::min_element(differences_.begin(), differences_.end(), is_shorter)};
    weights_ = {Rational(1)};
    nearest_ = corral_[0];
    for (;;) {
      const auto is_before = [this](const Point& a, const Point& b) {
        return inner_product(nearest_, a) < inner_product(nearest_, b);
      };
      const Point& first = *std::min_element(differences_.begin(), differences_.end(), is_before);
      const Rational squared = squared_length(nearest_);
      if (inner_product(nearest_, first) >= squared) return squared;
      corral_.push_back(first);
      weights_.push_back(0);
      come_nearer();
    }
  }

 private:
  // The point of least length of the affine hull of the corral, by its weights: all products of it
  // with points of the corral are one number.
  std::vector<Rational> affine_weights() const {
    const std::size_t size = corral_.size();
    RationalMatrix rows(size + 1, std::vector<Rational>(size + 1, 0));
    std::vector<Rational> sums(size + 1, 0);
    sums[size] = 1;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) rows[i][j] = inner_product(corral_[i], corral_[j]);
      rows[i][size] = rows[size][i] = 1;
    }
    std::vector<Rational> weights = solve(rows, sums).value();
    weights.pop_back();
    return weights;
  }

  // Goes towards that point until it is inside of the corral, which loses what is in the way.
  void come_nearer() {
    for (;;) {
      const std::vector<Rational> wanted = affine_weights();
      Rational part = 1;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (sign(wanted[i]) >= 0) continue;
        part = std::min(part, Rational(weights_[i] / (weights_[i] - wanted[i])));
      }
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        weights_[i] += part * (wanted[i] - weights_[i]);
      }
      for (std::size_t i = weights_.size(); i-- > 0;) {
        if (sign(weights_[i]) > 0) continue;
        weights_.erase(weights_.begin() + static_cast<std::ptrdiff_t>(i));
        corral_.erase(corral_.begin() + static_cast<std::ptrdiff_t>(i));
      }
      nearest_ = weights_[0] * corral_[0];
      for (std::size_t i = 1; i < corral_.size(); ++i) {
        nearest_ = nearest_ + weights_[i] * corral_[i];
      }
      if (part == 1) return;
    }
  }

  std::vector<Point> differences_;
  std::vector<Point> corral_;  // affinely independent
  std::vector<Rational> weights_;
  Point nearest_;
};

}  // namespace

Rational squared_distance_to_hull(const Point& q, const std::vector<Point>& points) {
  return LeastLength(q, points).squared();
}

}  // namespace circumspect::check
