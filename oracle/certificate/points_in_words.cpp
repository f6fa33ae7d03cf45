#include "oracle/certificate/points_in_words.hpp"

#include <algorithm>

namespace circumspect::certificate {

std::string text_of(const Point& point) {
  const HomogeneousPoint q = homogeneous(point);
  std::string words;
  for (const Integer& x : q.numerators) words += x.get_str() + " ";
  return words + q.denominator.get_str();
}

namespace {

// How far a point is from the line of two, towards a third; all of them in one plane.
Rational height(const Point& a, const Point& b, const Point& towards, const Point& point) {
  return inner_product(cross_product(b - a, towards - a), cross_product(b - a, point - a));
}

// Between which parts of the way, 0 at one end and 1 at the other, it is in the triangle: from the
// first to the second, if that is not less.
std::pair<Rational, Rational> part_inside(const std::vector<Point>& triangle, const Point& from,
                                          const Point& to) {
  Rational first = 0;
  Rational last = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& a = triangle[i];
    const Point& b = triangle[(i + 1) % 3];
    const Rational start = height(a, b, triangle[(i + 2) % 3], from);
    const Rational end = height(a, b, triangle[(i + 2) % 3], to);
    if (sgn(start) < 0 && sgn(end) < 0) return {1, 0};
    if (sgn(start) < 0) first = std::max(first, Rational(start / (start - end)));
    if (sgn(end) < 0) last = std::min(last, Rational(start / (start - end)));
  }
  return {first, last};
}

}  // namespace

std::string balance(const std::vector<Point>& triangle, const Point& point) {
  std::vector<Rational> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& a = triangle[(i + 1) % 3];
    const Point& b = triangle[(i + 2) % 3];
    weights.push_back(-height(a, b, triangle[i], point) / height(a, b, triangle[i], triangle[i]));
  }
  weights.emplace_back(1);
  const Integer whole = common_denominator(weights);
  std::string words;
  for (const Rational& weight : weights) {
    words += (words.empty() ? "" : " ") + Rational(weight * whole).get_num().get_str();
  }
  return words;
}

std::optional<std::string> way_through(const std::vector<std::vector<Point>>& triangles,
                                       const Point& from, const Point& to) {
  std::string bends;
  int count = 0;
  Rational reached = 0;
  while (true) {
    std::size_t best = 0;
    Rational furthest = reached;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto [first, last] = part_inside(triangles[t], from, to);
      if (first > reached || last <= furthest) continue;
      best = t + 1;
      furthest = last;
    }
    if (best == 0) return std::nullopt;
    const std::string name = " " + std::to_string(best);
    if (furthest == 1) return std::to_string(count) + bends + name;
    reached = furthest;
    ++count;
    bends += name + " " + text_of(from + reached * (to - from));
  }
}

}  // namespace circumspect::certificate
