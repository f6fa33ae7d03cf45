#include "kernel/piecewise_linear/nearest_plane.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

namespace circumspect {
namespace {

// A slab: the points between two parallel planes.
struct Slab {
  Point normal;
  Rational low, high;  // of the product of a point and the normal

  Rational squared_width() const { return (high - low) * (high - low) / squared_length(normal); }
};

class Width {
 public:
  explicit Width(const std::vector<Point>& points) : points_(points) {}

  NearestPlane plane() {
    AffineHull hull = affine_hull(points_);
    assert(hull.dimension == 3);
    std::vector<std::size_t> some = std::move(hull.basis);
    Slab slab = narrowest(some);
    while (take_in_what_is_out(slab, some) && some.size() <= kMostPlacesOfWidth) {
      slab = narrowest(some);
    }
    slab = about(slab.normal, all_places());
    NearestPlane found{slab.normal, slab.squared_width() / 4, {}};
    std::sort(some.begin(), some.end());
    for (const std::size_t place : some) {
      const Rational at = inner_product(slab.normal, points_[place]);
      if (at == slab.low || at == slab.high) found.farthest.push_back(place);
    }
    return found;
  }

 private:
  std::vector<std::size_t> all_places() const {
    std::vector<std::size_t> places(points_.size());
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
    return places;
  }

  Slab about(Point normal, const std::vector<std::size_t>& places) const {
    Rational low, high;
    for (const std::size_t place : places) {
      Rational at = inner_product(normal, points_[place]);
      if (place == places.front() || at < low) low = at;
      if (place == places.front() || at > high) high = std::move(at);
    }
    return {std::move(normal), std::move(low), std::move(high)};
  }

  // Where the width is a linear function of n on a cone of normals n, its quotient by |n| is least
  // on an extreme ray, which is at right angles to two edges of the hull. All pairs of points are
  // tried as these edges.
  Slab narrowest(const std::vector<std::size_t>& places) const {
    std::vector<Point> edges;
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        edges.push_back(points_[places[j]] - points_[places[i]]);
      }
    }
    std::optional<Slab> best;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = i + 1; j < edges.size(); ++j) {
        Point normal = cross_product(edges[i], edges[j]);
        if (sign(squared_length(normal)) == 0) continue;
        Slab slab = about(std::move(normal), places);
        if (!best || slab.squared_width() < best->squared_width()) best = std::move(slab);
      }
    }
    return *best;
  }

  // Adds the lowest and the highest point, if they are not in the slab; false if all are in it.
  bool take_in_what_is_out(const Slab& slab, std::vector<std::size_t>& some) const {
    std::optional<std::size_t> lowest, highest;
    Rational low = slab.low, high = slab.high;
    for (std::size_t place = 0; place < points_.size(); ++place) {
      const Rational at = inner_product(slab.normal, points_[place]);
      if (at < low) {
        low = at;
        lowest = place;
      } else if (at > high) {
        high = at;
        highest = place;
      }
    }
    if (lowest) some.push_back(*lowest);
    if (highest) some.push_back(*highest);
    return lowest || highest;
  }

  const std::vector<Point>& points_;
};

}  // namespace

NearestPlane nearest_plane(const std::vector<Point>& points) { return Width(points).plane(); }

}  // namespace circumspect
