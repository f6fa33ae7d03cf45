#include "oracle/judge/within/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace circumspect::check {
namespace {

// Points as integers over one positive denominator: fractions are reduced once, at the end.
using Whole = Triple<Integer>;

Rational quotient(const Integer& numerator, const Integer& denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

class WholePoints {
 public:
  WholePoints(const std::vector<Point>& corners, const Point& point) {
    for (const Point& corner : corners) denominator_ = common_denominator(corner, denominator_);
    denominator_ = common_denominator(point, denominator_);
    for (const Point& corner : corners) corners_.push_back(scaled(corner));
    point_ = scaled(point);
  }

  Rational to_segment(std::size_t first, std::size_t last) const {
    const Whole along = difference(corners_[last], corners_[first]);
    const Whole to = difference(point_, corners_[first]);
    const Integer at = inner_product(to, along);
    if (sign(at) <= 0) return squared(inner_product(to, to));
    const Integer length = inner_product(along, along);
    if (at >= length) {
      const Whole beyond = difference(point_, corners_[last]);
      return squared(inner_product(beyond, beyond));
    }
    return squared(inner_product(to, to) * length - at * at, length);
  }

  Rational to_triangle() const {
    const Whole u = difference(corners_[1], corners_[0]), v = difference(corners_[2], corners_[0]);
    const Whole to = difference(point_, corners_[0]);
    const Integer uu = inner_product(u, u), vv = inner_product(v, v), uv = inner_product(u, v);
    const Integer tu = inner_product(to, u), tv = inner_product(to, v);
    const Integer gram = uu * vv - uv * uv;
    const Integer s = vv * tu - uv * tv, t = uu * tv - uv * tu;
    if (sign(s) >= 0 && sign(t) >= 0 && s + t <= gram) {
      const Integer height = inner_product(to, cross_product(u, v));
      return squared(height * height, gram);
    }
    return std::min({to_segment(0, 1), to_segment(1, 2), to_segment(2, 0)});
  }

 private:
  Whole scaled(const Point& point) const {
    Whole result;
    for (std::size_t i = 0; i < point.size(); ++i) {
      result[i] = numerator_over(denominator_, point[i]);
    }
    return result;
  }
  Rational squared(const Integer& numerator, const Integer& over = 1) const {
    return quotient(numerator, over * denominator_ * denominator_);
  }

  std::vector<Whole> corners_;
  Whole point_;
  Integer denominator_ = 1;
};

// Between the points of two lines that are nearest to each other, if both are in the segments; what
// lies at an end of one of them is found elsewhere.
std::optional<Rational> between_lines(const Point& a, const Point& b, const Point& c,
                                      const Point& d) {
  const Point u = b - a, v = d - c, w = c - a;
  const Rational uu = squared_length(u), vv = squared_length(v), uv = inner_product(u, v);
  const Rational gram = uu * vv - uv * uv;
  if (sign(gram) == 0) return std::nullopt;
  const Rational wu = inner_product(w, u), wv = inner_product(w, v);
  const Rational s = (vv * wu - uv * wv) / gram;
  const Rational t = (uv * wu - uu * wv) / gram;
  if (sign(s) < 0 || s > 1 || sign(t) < 0 || t > 1) return std::nullopt;
  return squared_distance(a + s * u, c + t * v);
}

// The power of two that is nearest to the size of a number, but for one. Requires: it is not 0.
long magnitude(const Rational& value) {
  return static_cast<long>(bit_length(value.get_num())) -
         static_cast<long>(bit_length(value.get_den()));
}

Rational over_power_of_two(const Rational& value, long exponent) {
  const auto bits = static_cast<unsigned long>(std::abs(exponent));
  return exponent >= 0 ? Rational(value >> bits) : Rational(value << bits);
}

using Direction = Triple<double>;

// The heights of some points over a plane through the origin, times the length of its normal n.
Interval heights(const Direction& n, std::span<const RoundedPoint> points) {
  const Triple<Interval> normal = {exactly(n[0]), exactly(n[1]), exactly(n[2])};
  Interval found = inner_product(normal, points.front());
  for (const RoundedPoint& p : points.subspan(1)) found = hull(found, inner_product(normal, p));
  return found;
}

// Is there so much room between the heights of two simplices that they are more than `distance`
// apart? They are if the room is larger than distance·|n|, and |n| is at most Σ|nᵢ|.
bool parts(const Direction& n, std::span<const RoundedPoint> a, std::span<const RoundedPoint> b,
           double distance) {
  const Interval of_a = heights(n, a), of_b = heights(n, b);
  const Interval length =
      exactly(std::abs(n[0])) + exactly(std::abs(n[1])) + exactly(std::abs(n[2]));
  const double room = std::max((of_a - of_b).low, (of_b - of_a).low);
  return room > (exactly(distance) * length).high;
}

}  // namespace

RoundedPoint rounded(const Point& point) {
  RoundedPoint result;
  for (std::size_t i = 0; i < point.size(); ++i) result[i] = enclosing(point[i]);
  return result;
}

Rational upper_square_root(const Rational& squared) {
  if (sign(squared) == 0) return 0;
  const long half = magnitude(squared) / 2;
  const double root = std::sqrt(upper_double(over_power_of_two(squared, 2 * half)));
  return over_power_of_two(
      exact_value(std::nextafter(root, std::numeric_limits<double>::infinity())), -half);
}

Rounding::Rounding(const std::vector<Point>& points) {
  constexpr long kHarmless = 100;
  std::optional<long> largest;
  for (const Point& point : points) {
    for (const Rational& x : point) {
      if (sign(x) != 0) largest = std::max(largest.value_or(magnitude(x)), magnitude(x));
    }
  }
  if (largest && std::abs(*largest) > kHarmless) exponent_ = *largest;
}

RoundedPoint Rounding::point(const Point& point) const {
  if (exponent_ == 0) return rounded(point);
  Point scaled;
  for (const Rational& x : point) scaled.push_back(over_power_of_two(x, exponent_));
  return rounded(scaled);
}

RoundedPoint Rounding::point(std::span<const double> point) const {
  RoundedPoint result;
  if (exponent_ == 0) {
    std::transform(point.begin(), point.end(), result.begin(), exactly);
    return result;
  }
  Point exact;
  for (const double x : point) exact.push_back(exact_value(x));
  return this->point(exact);
}

std::vector<RoundedPoint> Rounding::points(const std::vector<Point>& points) const {
  std::vector<RoundedPoint> result;
  result.reserve(points.size());
  for (const Point& one : points) result.push_back(point(one));
  return result;
}

double Rounding::distance(const Rational& squared) const {
  return upper_double(over_power_of_two(upper_square_root(squared), exponent_));
}

// Sums and differences of two coordinates change by at most √2 times as much.
Box box_about(std::span<const RoundedPoint> points, double distance) {
  Box box;
  box.low.fill(std::numeric_limits<double>::infinity());
  box.high.fill(-std::numeric_limits<double>::infinity());
  for (const auto& [x, y, z] : points) {
    const std::array<Interval, 9> values = {x, y, z, x + y, x - y, x + z, x - z, y + z, y - z};
    for (std::size_t i = 0; i < values.size(); ++i) {
      box.low[i] = std::min(box.low[i], values[i].low);
      box.high[i] = std::max(box.high[i], values[i].high);
    }
  }
  for (std::size_t i = 0; distance > 0 && i < box.low.size(); ++i) {
    const Interval step = exactly((i < 3 ? 1 : 2) * distance);
    box.low[i] = (exactly(box.low[i]) - step).low;
    box.high[i] = (exactly(box.high[i]) + step).high;
  }
  return box;
}

// Planes at right angles to these directions are tried: the differences of corners, the edges, what
// is at right angles to an edge and leads to the other simplex, and the normals of pairs of edges
// and of the planes through these and an edge. Whatever the direction, `parts` decides.
bool certainly_apart(std::span<const RoundedPoint> a, std::span<const RoundedPoint> b,
                     double distance) {
  const auto apart = [&](const Direction& n) { return parts(n, a, b, distance); };
  const auto towards = [](const RoundedPoint& to, const RoundedPoint& from) {
    return Direction{to[0].low - from[0].low, to[1].low - from[1].low, to[2].low - from[2].low};
  };
  for (const RoundedPoint& p : a) {
    for (const RoundedPoint& q : b) {
      if (apart(towards(p, q))) return true;
    }
  }
  std::array<Direction, 6> edges;
  std::size_t count = 0;
  for (const auto& [own, other] : {std::pair{a, b}, std::pair{b, a}}) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t j = i + 1; j < own.size(); ++j) {
        const Direction edge = towards(own[j], own[i]);
        edges[count++] = edge;
        if (apart(edge)) return true;
        for (const RoundedPoint& q : other) {
          Direction across = towards(q, own[i]);
          const double along = inner_product(across, edge) / inner_product(edge, edge);
          for (std::size_t k = 0; k < 3; ++k) across[k] -= along * edge[k];
          if (apart(across)) return true;
        }
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const Direction normal = cross_product(edges[i], edges[j]);
      if (apart(normal) || apart(cross_product(normal, edges[i])) ||
          apart(cross_product(normal, edges[j]))) {
        return true;
      }
    }
  }
  return false;
}

Rational squared_distance_to(const std::vector<Point>& simplex, const Point& point) {
  if (simplex.size() == 1) return squared_distance(simplex[0], point);
  const WholePoints points(simplex, point);
  return simplex.size() == 2 ? points.to_segment(0, 1) : points.to_triangle();
}

// Two disjoint convex polytopes are nearest to each other at a vertex of one of them, or inside an
// edge of each.
Rational squared_distance_between(const std::vector<Point>& a, const std::vector<Point>& b) {
  Rational least = squared_distance_to(b, a[0]);
  for (const Point& corner : a) least = std::min(least, squared_distance_to(b, corner));
  for (const Point& corner : b) least = std::min(least, squared_distance_to(a, corner));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = i + 1; j < a.size(); ++j) {
      for (std::size_t k = 0; k < b.size(); ++k) {
        for (std::size_t l = k + 1; l < b.size(); ++l) {
          if (const auto found = between_lines(a[i], a[j], b[k], b[l])) {
            least = std::min(least, *found);
          }
        }
      }
    }
  }
  return least;
}

}  // namespace circumspect::check
