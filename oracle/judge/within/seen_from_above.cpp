#include "oracle/judge/within/seen_from_above.hpp"

#include <algorithm>

namespace circumspect::check {
namespace {

Point normal_to(const PointSet& points, const Simplex& t) {
  return cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
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
  const Triple<Interval> u = difference(at(1), at(0)), v = difference(at(2), at(0));
  normal_ = cross_product(u, v);
  const int first = certain_sign(normal_[0]);
  is_reversed_ =
      (first != 0 ? first : sign(inner_product(normal_to(complex.points, t), exact_normal()))) < 0;
  if (is_reversed_) normal_ = cross_product(v, u);
}

Simplex SeenFromAbove::own(Simplex triangle) const {
  const bool is_first = triangle == complex_.polygons[polygon_].triangles.front();
  const bool is_clockwise =
      is_first ? is_reversed_
               : sign(inner_product(exact_normal(), normal_to(complex_.points, triangle))) < 0;
  if (is_clockwise) std::swap(triangle[1], triangle[2]);
  return triangle;
}

int SeenFromAbove::turn(const Simplex& triangle) const {
  const auto at = [&](std::size_t place) -> const RoundedPoint& {
    return rounded_[static_cast<std::size_t>(triangle[place])];
  };
  const Triple<Interval> across = cross_product(difference(at(1), at(0)), difference(at(2), at(0)));
  if (const int turn = certain_sign(inner_product(normal_, across)); turn != 0) return turn;
  return sign(inner_product(exact_normal(), normal_to(points_, triangle)));
}

const Point& SeenFromAbove::exact_normal() const {
  if (exact_normal_.empty()) exact_normal_ = normal_of(complex_, polygon_);
  return exact_normal_;
}

}  // namespace circumspect::check
