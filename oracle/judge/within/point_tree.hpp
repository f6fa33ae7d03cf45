// All points in a tree of boxes of doubles, each half as many as the one above. It answers which of
// them are above a plane, asking about few.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/boxes/interval.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/within/distance.hpp"

namespace circumspect::check {

// The plane through three points.
using Three = std::array<Vertex, 3>;

class PointTree {
 public:
  explicit PointTree(const PointSet& points)
      : points_(points),
        rounded_(Rounding(points.points()).points(points.points())),
        order_(all_vertices(points)) {
    build(0, order_.size());
  }

  // A point above the plane through three, from where they turn counterclockwise, if there is one;
  // of those that are certainly there the highest.
  std::optional<Vertex> above(const Three& plane) const {
    Query query(*this, plane);
    visit(
        0, 0, order_.size(),
        [&](const RoundedPoint& bounds) { return query.heights(bounds).high > query.highest; },
        [&](Vertex v) {
          const Interval height = query.heights(at(v));
          if (height.low > query.highest) {
            query.highest = height.low;
            query.found = v;
          } else if (height.high > 0 && !query.found && side(plane, v) > 0) {
            query.found = v;
          }
        });
    return query.found;
  }
  // All points of the plane, ascending.
  std::vector<Vertex> on(const Three& plane) const {
    const Query query(*this, plane);
    std::vector<Vertex> found;
    const auto may_hold = [&](const RoundedPoint& bounds) {
      return certain_sign(query.heights(bounds)) == 0;
    };
    visit(0, 0, order_.size(), may_hold, [&](Vertex v) {
      if (may_hold(at(v)) && side(plane, v) == 0) found.push_back(v);
    });
    std::sort(found.begin(), found.end());
    return found;
  }
  // Positive above, zero in the plane.
  int side(const Three& plane, Vertex v) const {
    if (v == plane[0] || v == plane[1] || v == plane[2]) return 0;
    const std::array<Vertex, 4> four = {plane[0], plane[1], plane[2], v};
    return -orientation(points_.configuration(), kSpace, four);
  }

 private:
  static constexpr std::size_t kLeaf = 8;

  // The heights over a plane, times a positive number, that the points between some bounds may
  // have.
  struct Query {
    Query(const PointTree& tree, const Three& plane) : from(tree.at(plane[0])) {
      normal =
          cross_product(difference(tree.at(plane[1]), from), difference(tree.at(plane[2]), from));
    }
    Interval heights(const RoundedPoint& bounds) const {
      return inner_product(normal, difference(bounds, from));
    }

    RoundedPoint from;
    Triple<Interval> normal;
    double highest = 0;
    std::optional<Vertex> found = {};
  };

  const RoundedPoint& at(Vertex v) const { return rounded_[static_cast<std::size_t>(v)]; }

  // The subtree of the points from `first` up to `last` is numbered `node`, its halves 2·node + 1
  // and 2·node + 2.
  void build(std::size_t first, std::size_t last, std::size_t node = 0) {
    if (bounds_.size() <= node) bounds_.resize(node + 1);
    RoundedPoint box = at(order_[first]);
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) box[axis] = hull(box[axis], at(order_[i])[axis]);
    }
    bounds_[node] = box;
    if (last - first <= kLeaf) return;
    const auto length = [&](std::size_t axis) { return box[axis].high - box[axis].low; };
    std::size_t longest = 0;
    for (const std::size_t axis : {std::size_t{1}, std::size_t{2}}) {
      if (length(axis) > length(longest)) longest = axis;
    }
    const auto place = [&](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(place(first), place(middle), place(last),
                     [&](Vertex a, Vertex b) { return at(a)[longest].low < at(b)[longest].low; });
    build(first, middle, 2 * node + 1);
    build(middle, last, 2 * node + 2);
  }

  template <class IsOfInterest, class Look>
  void visit(std::size_t node, std::size_t first, std::size_t last, const IsOfInterest& is_wanted,
             const Look& look) const {
    if (!is_wanted(bounds_[node])) return;
    if (last - first <= kLeaf) {
      for (std::size_t i = first; i < last; ++i) look(order_[i]);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    visit(2 * node + 1, first, middle, is_wanted, look);
    visit(2 * node + 2, middle, last, is_wanted, look);
  }

  const PointSet& points_;
  std::vector<RoundedPoint> rounded_;
  std::vector<Vertex> order_;
  std::vector<RoundedPoint> bounds_;  // of the subtrees
};

}  // namespace circumspect::check
