#include "oracle/judge/within/seen_from_above.hpp"

#include <algorithm>
#include <cmath>

namespace circumspect::check {
namespace {

using Direction = std::array<double, 3>;

// More than what products that vanish leave out, if other factors are no larger than that.
constexpr double kVanishing = 1e-200;
constexpr double kLarge = 1e120;

Direction towards(const RoundedPoint& from, const RoundedPoint& to) {
  return {to.at[0] - from.at[0], to.at[1] - from.at[1], to.at[2] - from.at[2]};
}
double largest(const Direction& d) {
  return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
}
Direction normal_to(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point normal_to(const PointSet& points, const Simplex& t) {
  const Point a = points[t[1]] - points[t[0]], b = points[t[2]] - points[t[0]];
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Point normal_of(const PiecewiseLinearComplex& complex, std::size_t polygon) {
  const Point normal = normal_to(complex.points, complex.polygons[polygon].triangles.front());
  const auto first =
      std::find_if(normal.begin(), normal.end(), [](const Rational& x) { return sign(x) != 0; });
  return sign(*first) > 0 ? normal : Rational(-1) * normal;
}

SeenFromAbove::SeenFromAbove(const PiecewiseLinearComplex& complex,
                             const std::vector<RoundedPoint>& rounded_domain, std::size_t polygon,
                             const PointSet& points, const std::vector<RoundedPoint>& rounded)
    : complex_(complex), polygon_(polygon), points_(points), rounded_(rounded) {
  const Simplex& t = complex.polygons[polygon].triangles.front();
  const auto at = [&](std::size_t place) -> const RoundedPoint& {
    return rounded_domain[static_cast<std::size_t>(t[place])];
  };
  const Direction u = towards(at(0), at(1)), v = towards(at(0), at(2));
  normal_ = normal_to(u, v);
  size_ = largest(u) * largest(v);
  is_double_ = at(0).error == 0 && at(1).error == 0 && at(2).error == 0 && size_ <= kLarge;
  // A sum of two products of differences is off by at most 2·(2 + 1 + 1)u of what each may be.
  if (is_double_ && std::abs(normal_[0]) > 2e-15 * size_ + kVanishing) {
    is_reversed_ = normal_[0] < 0;
  } else {
    is_reversed_ = sign(inner_product(normal_to(complex_.points, t), exact_normal())) < 0;
  }
  if (is_reversed_) {
    for (double& x : normal_) x = -x;
  }
}

Simplex SeenFromAbove::own(Simplex triangle) const {
  const bool is_first = triangle == complex_.polygons[polygon_].triangles.front();
  const bool is_clockwise =
      is_first ? is_reversed_
               : sign(inner_product(exact_normal(), normal_to(complex_.points, triangle))) < 0;
  if (is_clockwise) std::swap(triangle[1], triangle[2]);
  return triangle;
}

// The determinant is a sum of 12 products of four differences; with all roundings each is off by less than 12u
// of what it may be.
int SeenFromAbove::turn(const Simplex& triangle) const {
  const RoundedPoint& a = rounded_[static_cast<std::size_t>(triangle[0])];
  const RoundedPoint& b = rounded_[static_cast<std::size_t>(triangle[1])];
  const RoundedPoint& c = rounded_[static_cast<std::size_t>(triangle[2])];
  if (is_double_ && a.error == 0 && b.error == 0 && c.error == 0) {
    const Direction v = towards(a, b), w = towards(a, c);
    const double size = largest(v) * largest(w);
    const Direction across = normal_to(v, w);
    const double found = normal_[0] * across[0] + normal_[1] * across[1] + normal_[2] * across[2];
    const double bound = 2e-14 * size_ * size + kVanishing;
    if (size <= kLarge && std::abs(found) > bound) return found > 0 ? 1 : -1;
  }
  return sign(inner_product(exact_normal(), normal_to(points_, triangle)));
}

const Point& SeenFromAbove::exact_normal() const {
  if (exact_normal_.empty()) exact_normal_ = normal_of(complex_, polygon_);
  return exact_normal_;
}

}  // namespace circumspect::check
