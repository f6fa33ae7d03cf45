#include <algorithm>
#include <cassert>
#include <utility>

#include "kernel/piecewise_linear/visibility.hpp"

namespace circumspect {
namespace {

using ConvexPolygon = std::vector<Point>;

Rational sum(const Point& point) {
  Rational sum = 0;
  for (const Rational& c : point) sum += c;
  return sum;
}

// The points at which an affine function is not negative.
struct Halfspace {
  Point normal;
  Rational offset;

  Rational height(const Point& p) const { return inner_product(normal, p) + offset; }
  Halfspace opposite() const { return {Rational(-1) * normal, -offset}; }
};

ConvexPolygon clipped(const ConvexPolygon& polygon, const Halfspace& halfspace) {
  std::vector<Rational> heights;
  for (const Point& p : polygon) heights.push_back(halfspace.height(p));
  ConvexPolygon result;
  const auto add = [&result](const Point& p) {
    if (result.empty() || result.back() != p) result.push_back(p);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (sign(heights[i]) >= 0) add(polygon[i]);
    if (sign(heights[i]) * sign(heights[next]) < 0) {
      const Rational at = heights[i] / (heights[i] - heights[next]);
      add(polygon[i] + at * (polygon[next] - polygon[i]));
    }
  }
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

// Positive on the left of the line from a to b.
Halfspace left_of(const Point& a, const Point& b) {
  const Point along = b - a;
  const Point normal = {-along[1], along[0]};
  return {normal, -inner_product(normal, a)};
}

// The polygon (the interval) is the intersection of these.
std::vector<Halfspace> sides(const ConvexPolygon& polygon) {
  if (polygon[0].size() == 1) return {{{1}, -polygon[0][0]}, {{-1}, polygon[1][0]}};
  std::vector<Halfspace> sides;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sides.push_back(left_of(polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return sides;
}

// Three corners (two ends) that are affinely independent; nothing if there are none.
std::optional<ConvexPolygon> independent_corners(const ConvexPolygon& polygon) {
  if (polygon.size() < 2) return std::nullopt;
  if (polygon[0].size() == 1) return polygon;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    if (left_of(polygon[0], polygon[i]).height(polygon[i + 1]) != 0) {
      return ConvexPolygon{polygon[0], polygon[i], polygon[i + 1]};
    }
  }
  return std::nullopt;
}

bool is_clockwise(const ConvexPolygon& corners) {
  if (corners[0].size() == 1) return corners[1] < corners[0];
  return left_of(corners[0], corners[1]).height(corners[2]) < 0;
}

// A polygon minus another one with the given sides: it is cut along one line after the other, and
// each part that lies outside is kept; or the whole polygon, if the two do not overlap.
std::vector<ConvexPolygon> difference(const ConvexPolygon& polygon,
                                      const std::vector<Halfspace>& removed) {
  std::vector<ConvexPolygon> left;
  ConvexPolygon rest = polygon;
  for (const Halfspace& side : removed) {
    const ConvexPolygon outside = clipped(rest, side.opposite());
    if (independent_corners(outside)) left.push_back(outside);
    rest = clipped(rest, side);
    if (!independent_corners(rest)) return {polygon};
  }
  return left;
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
  for (const std::size_t axis : axes_) {
    directions_.emplace_back();
    for (const Point& p : simplex_) directions_.back().push_back(p[axis] - v_[axis]);
  }
  open_ = {k_ == 2 ? ConvexPolygon{{0}, {1}} : ConvexPolygon{{0, 0}, {1, 0}, {0, 1}}};
}

Point SightCone::coordinates(const Point& point) const {
  return *solve(directions_, on_axes(point - v_, axes_));
}

// The part of an obstacle in the cone and before the simplex, projected on that.
ConvexPolygon SightCone::shadow(ConvexPolygon obstacle) const {
  for (std::size_t i = 0; i < k_; ++i) {
    Point side(k_);
    side[i] = 1;
    obstacle = clipped(obstacle, {side, 0});
  }
  obstacle = clipped(obstacle, {Point(k_, -1), 1});
  for (Point& c : obstacle) {
    c = (1 / sum(c)) * c;
    c.erase(c.begin());
  }
  const auto corners = independent_corners(obstacle);
  if (!corners) return {};
  if (is_clockwise(*corners)) std::reverse(obstacle.begin(), obstacle.end());
  return obstacle;
}

bool SightCone::obstruct(const std::vector<Point>& obstacle) {
  assert(obstacle.size() == k_);
  const bool comes_before = std::any_of(obstacle.begin(), obstacle.end(),
                                        [](const Point& corner) { return sum(corner) < 1; });
  // v, whose coordinates are zero, is in the hull of the obstacle iff these are dependent.
  const bool has_v_in_hull = !solve(obstacle, Point(k_));
  if (!comes_before || has_v_in_hull) return false;
  const ConvexPolygon covered = shadow(obstacle);
  if (covered.empty()) return false;
  const std::vector<Halfspace> removed = sides(covered);
  std::vector<ConvexPolygon> left;
  for (const ConvexPolygon& piece : open_) {
    const std::vector<ConvexPolygon> rest = difference(piece, removed);
    left.insert(left.end(), rest.begin(), rest.end());
  }
  return std::exchange(open_, left) != left;
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
