#include "oracle/judge/within/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace circumspect::check {
namespace {

// Points as integers over one positive denominator: fractions are reduced once, at the end.
using Whole = std::array<Integer, 3>;

Whole difference(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Integer product(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rational quotient(const Integer& numerator, const Integer& denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

class WholePoints {
 public:
  WholePoints(const std::vector<Point>& corners, const Point& point) {
    for (const Point& corner : corners) take_denominators(corner);
    take_denominators(point);
    for (const Point& corner : corners) corners_.push_back(scaled(corner));
    point_ = scaled(point);
  }

  Rational to_segment(std::size_t first, std::size_t last) const {
    const Whole along = difference(corners_[last], corners_[first]);
    const Whole to = difference(point_, corners_[first]);
    const Integer at = product(to, along);
    if (sign(at) <= 0) return squared(product(to, to));
    const Integer length = product(along, along);
    if (at >= length) {
      const Whole beyond = difference(point_, corners_[last]);
      return squared(product(beyond, beyond));
    }
    return squared(product(to, to) * length - at * at, length);
  }

  Rational to_triangle() const {
    const Whole u = difference(corners_[1], corners_[0]), v = difference(corners_[2], corners_[0]);
    const Whole to = difference(point_, corners_[0]);
    const Integer uu = product(u, u), vv = product(v, v), uv = product(u, v);
    const Integer tu = product(to, u), tv = product(to, v);
    const Integer gram = uu * vv - uv * uv;
    const Integer s = vv * tu - uv * tv, t = uu * tv - uv * tu;
    if (sign(s) >= 0 && sign(t) >= 0 && s + t <= gram) {
      const Whole normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                            u[0] * v[1] - u[1] * v[0]};
      const Integer height = product(to, normal);
      return squared(height * height, gram);
    }
    return std::min({to_segment(0, 1), to_segment(1, 2), to_segment(2, 0)});
  }

 private:
  void take_denominators(const Point& point) {
    for (const Rational& x : point) {
      const Integer& own = x.get_den();
      if (denominator_ % own != 0) denominator_ = least_common_multiple(denominator_, own);
    }
  }
  Whole scaled(const Point& point) const {
    Whole result;
    for (std::size_t i = 0; i < point.size(); ++i) {
      result[i] = denominator_ / point[i].get_den() * point[i].get_num();
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

using Direction = std::array<double, 3>;

Direction difference(const Direction& a, const Direction& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double product(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Direction vector_product(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Heights of points over a plane through the origin, n·p with doubles for n. Each sum that is computed differs
// from the exact one by at most γ₃ Σ|nᵢ pᵢ| for its roundings (γ₃ = 3u / (1 − 3u) < 4·10⁻¹⁶, u = 2⁻⁵³),
// by Σ|nᵢ| times the error of the point, and by less than 10⁻³⁰⁰ where products vanish.
struct Heights {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double size = 0;   // the largest Σ|nᵢ pᵢ|
  double error = 0;  // of a point
};
Heights heights(const Direction& n, std::span<const RoundedPoint> points) {
  Heights found;
  for (const RoundedPoint& p : points) {
    const double height = product(n, p.at);
    found.low = std::min(found.low, height);
    found.high = std::max(found.high, height);
    const double size =
        std::abs(n[0] * p.at[0]) + std::abs(n[1] * p.at[1]) + std::abs(n[2] * p.at[2]);
    found.size = std::max(found.size, size);
    found.error = std::max(found.error, p.error);
  }
  return found;
}

// Is there so much room between the heights of two simplices that they are more than `distance` apart? They are
// if the room is larger than distance·|n|, and |n| is at most Σ|nᵢ|. The errors are counted more than
// twice; where a number is infinite or none, the answer is false.
bool parts(const Direction& n, std::span<const RoundedPoint> a, std::span<const RoundedPoint> b,
           double distance) {
  const Heights of_a = heights(n, a), of_b = heights(n, b);
  const double length = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
  const double room = std::max(of_a.low - of_b.high, of_b.low - of_a.high);
  const double errors = 3 * length * (of_a.error + of_b.error) + 1e-15 * (of_a.size + of_b.size);
  return room > 1.001 * (distance * length + errors) + 1e-299;
}

}  // namespace

RoundedPoint rounded(const Point& point) {
  RoundedPoint result;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double x = result.at[i] = point[i].get_d();
    if (!std::isfinite(x)) {
      result.at[i] = 0;
      result.error = std::numeric_limits<double>::infinity();
    } else if (exact_value(x) != point[i]) {
      // GMP cuts off what is less than one unit in the last place.
      result.error = std::max(result.error, 0x1p-51 * std::abs(x) + 0x1p-1000);
    }
  }
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

std::vector<RoundedPoint> Rounding::points(const std::vector<Point>& points) const {
  std::vector<RoundedPoint> result;
  result.reserve(points.size());
  for (const Point& one : points) result.push_back(point(one));
  return result;
}

double Rounding::distance(const Rational& squared) const {
  return upper_double(over_power_of_two(upper_square_root(squared), exponent_));
}

// Sums and differences of two coordinates change by at most √2 times as much, and their errors add up.
Box box_about(std::span<const RoundedPoint> points, double distance) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box;
  box.low.fill(kInfinity);
  box.high.fill(-kInfinity);
  double error = 0;
  for (const RoundedPoint& point : points) {
    const auto& [x, y, z] = point.at;
    const std::array<double, 9> values = {x, y, z, x + y, x - y, x + z, x - z, y + z, y - z};
    for (std::size_t i = 0; i < values.size(); ++i) {
      box.low[i] = std::min(box.low[i], values[i]);
      box.high[i] = std::max(box.high[i], values[i]);
    }
    error = std::max(error, point.error);
  }
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    // A sum of two doubles is off by at most half a unit in the last place: one step outward makes up for it.
    const double low = i < 3 ? box.low[i] : std::nextafter(box.low[i], -kInfinity);
    const double high = i < 3 ? box.high[i] : std::nextafter(box.high[i], kInfinity);
    const double step = (i < 3 ? 1 : 2) * (distance + error);
    const bool is_known = std::isfinite(step);
    box.low[i] = step == 0  ? low
                 : is_known ? std::nextafter(low - 1.001 * step, -kInfinity)
                            : -kInfinity;
    box.high[i] = step == 0  ? high
                  : is_known ? std::nextafter(high + 1.001 * step, kInfinity)
                             : kInfinity;
  }
  return box;
}

// Planes at right angles to these directions are tried: the differences of corners, the edges, what is at right
// angles to an edge and leads to the other simplex, and the normals of pairs of edges and of the planes
// through these and an edge. Whatever the direction, `parts` decides.
bool certainly_apart(std::span<const RoundedPoint> a, std::span<const RoundedPoint> b,
                     double distance) {
  const auto apart = [&](const Direction& n) { return parts(n, a, b, distance); };
  for (const RoundedPoint& p : a) {
    for (const RoundedPoint& q : b) {
      if (apart(difference(p.at, q.at))) return true;
    }
  }
  std::array<Direction, 6> edges;
  std::size_t count = 0;
  for (const auto& [own, other] : {std::pair{a, b}, std::pair{b, a}}) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t j = i + 1; j < own.size(); ++j) {
        const Direction edge = difference(own[j].at, own[i].at);
        edges[count++] = edge;
        if (apart(edge)) return true;
        for (const RoundedPoint& q : other) {
          Direction across = difference(q.at, own[i].at);
          const double along = product(across, edge) / product(edge, edge);
          for (std::size_t k = 0; k < 3; ++k) across[k] -= along * edge[k];
          if (apart(across)) return true;
        }
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const Direction normal = vector_product(edges[i], edges[j]);
      if (apart(normal) || apart(vector_product(normal, edges[i])) ||
          apart(vector_product(normal, edges[j]))) {
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
