#include <algorithm>
#include <cassert>
#include <utility>

#include "kernel/piecewise_linear/regions.hpp"

namespace circumspect {
namespace {

std::vector<Simplex> in_order(std::vector<Simplex> walls) {
  for (Simplex& wall : walls) std::sort(wall.begin(), wall.end());
  std::sort(walls.begin(), walls.end());
  return walls;
}

// Positive if the three turn left in the plane of two coordinates.
int turn(const Point& p, const Point& q, const Point& r, std::size_t x, std::size_t y) {
  return sign(cross_product(q - p, r - p, x, y));
}

}  // namespace

WallSet::WallSet(const PointSet& points, std::vector<Simplex> walls)
    : points_(points.points()),
      walls_(in_order(std::move(walls))),
      index_(CellBoxes(points).index_of(walls_)) {}

std::size_t WallSet::place_of(const Simplex& wall) const {
  const auto found = std::lower_bound(walls_.begin(), walls_.end(), wall);
  assert(found != walls_.end() && *found == wall);
  return static_cast<std::size_t>(found - walls_.begin());
}

std::vector<Point> WallSet::corners(std::size_t wall) const {
  std::vector<Point> corners;
  for (const Vertex v : walls_[wall]) corners.push_back(point(v));
  return corners;
}

// It points to the back.
Point WallSet::normal(std::size_t wall) const {
  const Simplex& w = walls_[wall];
  const Point a = point(w[1]) - point(w[0]);
  if (w.size() == 2) return {a[1], -a[0]};
  return cross_product(a, point(w[2]) - point(w[0]));
}

// det[w_0 − p; …; w_{d−1} − p], as in `orientation`.
Rational WallSet::height(std::size_t wall, const Point& p) const {
  return inner_product(normal(wall), point(walls_[wall][0]) - p);
}

int WallSet::side_of(std::size_t wall, const Point& p) const { return sign(height(wall, p)); }

std::vector<std::size_t> WallSet::at(const Point& p) const {
  std::vector<std::size_t> found = near(box_around(p));
  std::erase_if(found, [&](std::size_t wall) {
    return side_of(wall, p) != 0 || place_in(wall, p, std::nullopt) == Meeting::kNone;
  });
  return found;
}

// Where a point of the hyperplane lies in a wall, or in the cone over it: for every facet of the
// wall (for a cone, every facet at the apex), it must be on the same side as the opposite corner.
WallSet::Meeting WallSet::place_in(std::size_t wall, const Point& p,
                                   std::optional<Vertex> apex) const {
  const Simplex& w = walls_[wall];
  Meeting meeting = Meeting::kInside;
  std::size_t x = 0, y = 1;
  if (w.size() == 3) {
    const Point n = normal(wall);
    if (n[2] == 0) (n[1] != 0 ? y : x) = 2;
  }
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (apex && w[i] == *apex) continue;
    const Point& a = point(w[i]);
    const Point& b = point(w[(i + 1) % w.size()]);
    int side = 0;
    if (w.size() == 2) {
      side = sign(inner_product(p - b, a - b));
    } else {
      const Point& c = point(w[(i + 2) % 3]);
      side = turn(b, c, p, x, y) * turn(b, c, a, x, y);
    }
    if (side < 0) return Meeting::kNone;
    if (side == 0) meeting = Meeting::kBoundary;
  }
  return meeting;
}

std::optional<std::vector<Crossing>> WallSet::crossings(const Point& from, const Point& to) const {
  return crossings(near(from, to), from, to, std::nullopt);
}

std::optional<Rational> WallSet::free_part(const Point& from, const Point& way) const {
  Rational part = 1;
  for (const std::size_t wall : near(from, from + way)) {
    const Rational start = height(wall, from);
    const Rational end = height(wall, from + way);
    if (start == 0 && end == 0) return std::nullopt;
    if (start == 0 || sign(start) * sign(end) > 0) continue;
    const Rational at = start / (start - end);
    if (at > part || place_in(wall, from + at * way, std::nullopt) == Meeting::kNone) continue;
    while (part >= at) part /= 2;
  }
  return part;
}

std::optional<std::vector<Crossing>> WallSet::cone_crossings(Vertex apex,
                                                             std::span<const std::size_t> walls,
                                                             const Point& from,
                                                             const Point& to) const {
  return crossings(walls, from, to, apex);
}

std::optional<std::vector<Crossing>> WallSet::crossings(std::span<const std::size_t> walls,
                                                        const Point& from, const Point& to,
                                                        std::optional<Vertex> apex) const {
  std::vector<Crossing> found;
  for (const std::size_t wall : walls) {
    const Rational start = height(wall, from);
    const Rational end = height(wall, to);
    if (sign(start) * sign(end) > 0) continue;
    if (start == 0 && end == 0) return std::nullopt;
    const Rational at = start / (start - end);
    const Meeting meeting = place_in(wall, from + at * (to - from), apex);
    if (meeting == Meeting::kBoundary) return std::nullopt;
    if (meeting == Meeting::kInside) found.push_back({at, wall, start > end});
  }
  std::sort(found.begin(), found.end(),
            [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
  return found;
}

}  // namespace circumspect
