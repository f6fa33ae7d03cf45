#include "reference/piecewise_linear/sight_cone.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace circumspect {
namespace {

using ConvexPolygon = std::vector<Point>;

Rational sum(const Point& point) {
  Rational sum = 0;
  for (const Rational& c : point) sum += c;
  return sum;
}

// The part of a convex polygon in which an affine function is not negative.
ConvexPolygon clipped(const ConvexPolygon& polygon,
                      const std::function<Rational(const Point&)>& function) {
  std::vector<Rational> values;
  for (const Point& p : polygon) values.push_back(function(p));
  ConvexPolygon result;
  const auto add = [&result](const Point& p) {
    if (result.empty() || result.back() != p) result.push_back(p);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (sign(values[i]) >= 0) add(polygon[i]);
    if (sign(values[i]) * sign(values[next]) < 0) {
      const Rational at = values[i] / (values[i] - values[next]);
      add(polygon[i] + at * (polygon[next] - polygon[i]));
    }
  }
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

// Twice the area of a triangle of the plane; on a line, of two points only, the length.
Rational area(const Point& a, const Point& b, const Point& c) {
  if (a.size() == 1) return b[0] - a[0];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Three corners (two ends) that are affinely independent; none if there are none.
std::optional<ConvexPolygon> independent_corners(const ConvexPolygon& polygon) {
  if (polygon.size() < 2) return std::nullopt;
  if (polygon[0].size() == 1) return polygon;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    if (area(polygon[0], polygon[i], polygon[i + 1]) != 0) {
      return ConvexPolygon{polygon[0], polygon[i], polygon[i + 1]};
    }
  }
  return std::nullopt;
}

// For each edge of a polygon (each end of an interval) a function that is positive inside.
std::vector<std::function<Rational(const Point&)>> sides(const ConvexPolygon& polygon) {
  std::vector<std::function<Rational(const Point&)>> functions;
  if (polygon[0].size() == 1) {
    functions.push_back([a = polygon[0][0]](const Point& p) -> Rational { return p[0] - a; });
    functions.push_back([b = polygon[1][0]](const Point& p) -> Rational { return b - p[0]; });
    return functions;
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    functions.push_back([a = polygon[i], b = polygon[(i + 1) % polygon.size()]](const Point& p) {
      return area(a, b, p);
    });
  }
  return functions;
}

Rational negative(const Rational& value) { return -value; }

// What is left of a polygon when another, with the given sides, is taken away: cut along one line
// after the other, so that what lies outside falls off; or all of it if nothing is taken away.
std::vector<ConvexPolygon> difference(
    const ConvexPolygon& polygon,
    const std::vector<std::function<Rational(const Point&)>>& removed) {
  std::vector<ConvexPolygon> left;
  ConvexPolygon rest = polygon;
  for (const auto& side : removed) {
    const ConvexPolygon outside = clipped(rest, [&](const Point& p) { return negative(side(p)); });
    if (independent_corners(outside)) left.push_back(outside);
    rest = clipped(rest, side);
    if (!independent_corners(rest)) return {polygon};
  }
  return left;
}

Rational minor(const std::vector<Point>& rows, std::size_t row, std::size_t column) {
  const std::size_t r = (row + 1) % 3, s = (row + 2) % 3;
  const std::size_t c = (column + 1) % 3, e = (column + 2) % 3;
  return rows[r][c] * rows[s][e] - rows[r][e] * rows[s][c];
}

Rational determinant(const std::vector<Point>& rows) {
  if (rows.size() == 2) return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
  return rows[0][0] * minor(rows, 0, 0) + rows[0][1] * minor(rows, 0, 1) +
         rows[0][2] * minor(rows, 0, 2);
}

// For row vectors: c · rows = p iff c_i = inverse_i · p.
std::vector<Point> inverse(const std::vector<Point>& rows) {
  const Rational scale = 1 / determinant(rows);
  if (rows.size() == 2) {
    return {scale * Point{rows[1][1], -rows[1][0]}, scale * Point{-rows[0][1], rows[0][0]}};
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.push_back(scale * Point{minor(rows, i, 0), minor(rows, i, 1), minor(rows, i, 2)});
  }
  return result;
}

Point on_axes(const Point& point, const std::vector<std::size_t>& axes) {
  Point result;
  for (const std::size_t axis : axes) result.push_back(point[axis]);
  return result;
}

}  // namespace

SightCone::SightCone(Point v, std::vector<Point> simplex)
    : k_(simplex.size()), v_(std::move(v)), simplex_(std::move(simplex)) {
  std::vector<Point> all = simplex_;
  all.push_back(v_);
  axes_ = affine_hull(all).axes;
  assert(axes_.size() == k_ && (k_ == 2 || k_ == 3));
  std::vector<Point> rows;
  for (const Point& p : simplex_) rows.push_back(on_axes(p - v_, axes_));
  inverse_ = inverse(rows);
  open_ = {k_ == 2 ? ConvexPolygon{{0}, {1}} : ConvexPolygon{{0, 0}, {1, 0}, {0, 1}}};
}

Point SightCone::coordinates(const Point& point) const {
  const Point offset = on_axes(point - v_, axes_);
  Point result;
  for (const Point& row : inverse_) result.push_back(inner_product(row, offset));
  return result;
}

ConvexPolygon SightCone::shadow(ConvexPolygon obstacle) const {
  for (std::size_t i = 0; i < k_; ++i) {
    obstacle = clipped(obstacle, [i](const Point& c) -> Rational { return c[i]; });
  }
  obstacle = clipped(obstacle, [](const Point& c) -> Rational { return 1 - sum(c); });
  for (Point& c : obstacle) {
    c = (1 / sum(c)) * c;
    c.erase(c.begin());
  }
  if (const auto corners = independent_corners(obstacle)) {
    if (area(corners->front(), (*corners)[1], corners->back()) < 0) {
      std::reverse(obstacle.begin(), obstacle.end());
    }
    return obstacle;
  }
  return {};
}

bool SightCone::obstruct(const std::vector<Point>& obstacle) {
  const auto all = [&](const auto& condition) {
    return std::all_of(obstacle.begin(), obstacle.end(), condition);
  };
  if (all([](const Point& c) { return sum(c) >= 1; })) return false;
  for (std::size_t i = 0; i < k_; ++i) {
    if (all([i](const Point& c) { return sign(c[i]) <= 0; })) return false;
  }
  // Its plane (line) is that of its first corners.
  if (determinant({obstacle.begin(), obstacle.begin() + static_cast<std::ptrdiff_t>(k_)}) == 0) {
    return false;
  }
  const ConvexPolygon covered = shadow(obstacle);
  if (covered.empty()) return false;
  const auto removed = sides(covered);
  bool changed = false;
  std::vector<ConvexPolygon> left;
  for (const ConvexPolygon& piece : open_) {
    const std::vector<ConvexPolygon> rest = difference(piece, removed);
    changed = changed || rest.size() != 1 || rest.front() != piece;
    left.insert(left.end(), rest.begin(), rest.end());
  }
  open_ = std::move(left);
  return changed;
}

std::optional<std::vector<Point>> SightCone::open_part() const {
  if (open_.empty()) return std::nullopt;
  std::vector<Point> corners;
  const ConvexPolygon places = *independent_corners(open_.front());
  for (const Point& place : places) {
    Point corner = (1 - sum(place)) * simplex_[0];
    for (std::size_t i = 1; i < k_; ++i) corner = corner + place[i - 1] * simplex_[i];
    corners.push_back(std::move(corner));
  }
  return corners;
}

}  // namespace circumspect
