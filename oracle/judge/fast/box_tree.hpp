// Axis-parallel boxes of doubles, and a tree of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace circumspect::fast {

struct AxisBox {
  std::array<double, 3> low, high;

  void add(const AxisBox& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
  bool meets(const AxisBox& other) const {
    bool apart = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      apart |= high[axis] < other.low[axis];
      apart |= other.high[axis] < low[axis];
    }
    return !apart;
  }
};

// Requires: finite coordinates, three a point.
inline AxisBox box_of_point(std::span<const double> coordinates, std::size_t v) {
  const std::array<double, 3> at = {coordinates[3 * v], coordinates[3 * v + 1],
                                    coordinates[3 * v + 2]};
  return {at, at};
}

// The box of some points of the plane, where the third coordinate is 0, or of space.
template <std::size_t kDimension, typename Index>
AxisBox box_of_points(std::span<const double> coordinates, std::span<const Index> vertices) {
  AxisBox box{};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    double low = coordinates[static_cast<std::size_t>(vertices[0]) * kDimension + axis], high = low;
    for (const Index v : vertices) {
      const double x = coordinates[static_cast<std::size_t>(v) * kDimension + axis];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    box.low[axis] = low;
    box.high[axis] = high;
  }
  return box;
}

// A binary tree of boxes, which finds pairs that meet, and boxes that something else may meet.
class BoxTree {
 public:
  // Requires: fewer than 2^32 boxes.
  explicit BoxTree(std::vector<AxisBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    nodes_.reserve(2 * boxes_.size() / kLeaf + 2);
    if (!order_.empty()) grow(0, order_.size());
  }

  // Does visit(place) return true for all boxes, except those within a box for which is_beyond(box)
  // returns true? Also false if that takes more steps than `steps`, which is reduced by the steps
  // taken.
  template <class IsBeyond, class Visit>
  bool all_near(std::size_t& steps, const IsBeyond& is_beyond, const Visit& visit) const {
    std::vector<std::uint32_t> pending;
    if (!nodes_.empty()) pending.push_back(0);
    while (!pending.empty()) {
      if (steps == 0) return false;
      --steps;
      const std::uint32_t at = pending.back();
      const Node& node = nodes_[at];
      pending.pop_back();
      if (is_beyond(node.box)) continue;
      if (!node.is_leaf()) {
        pending.insert(pending.end(), {at + 1, node.right});
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (!is_beyond(boxes_[order_[i]]) && !visit(order_[i])) return false;
      }
    }
    return true;
  }

  // Does visit(a, b) return true for every two whose boxes meet? Also false if that takes more than
  // a number of steps.
  template <class Visit>
  bool all_pairs(std::size_t steps, const Visit& visit) const {
    if (nodes_.empty()) return true;
    std::vector<std::array<std::uint32_t, 2>> pending = {{0, 0}};
    while (!pending.empty()) {
      if (steps-- == 0) return false;
      const auto [a, b] = pending.back();
      pending.pop_back();
      const Node &first = nodes_[a], &second = nodes_[b];
      if (a != b && !first.box.meets(second.box)) continue;
      if (first.is_leaf() && second.is_leaf()) {
        if (!pairs_of(first, second, a == b, visit)) return false;
      } else if (a == b) {
        pending.push_back({a + 1, a + 1});
        pending.push_back({first.right, first.right});
        pending.push_back({a + 1, first.right});
      } else if (second.is_leaf() || (!first.is_leaf() && first.count() >= second.count())) {
        pending.push_back({a + 1, b});
        pending.push_back({first.right, b});
      } else {
        pending.push_back({a, b + 1});
        pending.push_back({a, second.right});
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t kLeaf = 4;

  struct Node {
    AxisBox box;
    std::uint32_t begin, end;  // in the order
    std::uint32_t right = 0;   // the second child; the first follows its parent

    bool is_leaf() const { return right == 0; }
    std::uint32_t count() const { return end - begin; }
  };

  // Half the middle of a box: a heuristic for splitting boxes, which decides nothing.
  double middle(std::uint32_t box, std::size_t axis) const {
    return boxes_[box].low[axis] / 4 + boxes_[box].high[axis] / 4;
  }

  std::uint32_t grow(std::size_t begin, std::size_t end) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    AxisBox box = boxes_[order_[begin]];
    for (std::size_t i = begin; i < end; ++i) box.add(boxes_[order_[i]]);
    nodes_.push_back({box, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    if (end - begin <= kLeaf) return place;
    std::size_t widest = 0;
    for (const std::size_t axis : {1, 2}) {
      const double width = box.high[axis] / 4 - box.low[axis] / 4;
      if (width > box.high[widest] / 4 - box.low[widest] / 4) widest = axis;
    }
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<long>(i); };
    const std::size_t half = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(half), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return middle(a, widest) < middle(b, widest);
    });
    grow(begin, half);
    const std::uint32_t right = grow(half, end);
    nodes_[place].right = right;
    return place;
  }

  template <class Visit>
  bool pairs_of(const Node& first, const Node& second, bool same, const Visit& visit) const {
    for (std::uint32_t i = first.begin; i < first.end; ++i) {
      const AxisBox& box = boxes_[order_[i]];
      for (std::uint32_t j = same ? i + 1 : second.begin; j < second.end; ++j) {
        if (box.meets(boxes_[order_[j]]) && !visit(order_[i], order_[j])) return false;
      }
    }
    return true;
  }

  std::vector<AxisBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace circumspect::fast
