#include "kernel/piecewise_linear/cell_index.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

namespace circumspect {
namespace {

// A vertex with fewer cells gets no tree of its own.
constexpr std::size_t kMany = 16;

Simplex in_both(const Simplex& a, const Simplex& b) {
  Simplex both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

bool has_one_of(const Simplex& few, const std::vector<Vertex>& ascending) {
  return std::any_of(few.begin(), few.end(), [&](Vertex v) {
    return std::binary_search(ascending.begin(), ascending.end(), v);
  });
}

// The middle of a box, doubled: a heuristic for splitting cells, which decides nothing.
std::array<double, 3> middle(const Box& box) {
  const auto finite = [](double x) { return std::clamp(x, -0x1p1000, 0x1p1000); };
  std::array<double, 3> middle;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    middle[axis] = finite(box.low[axis]) + finite(box.high[axis]);
  }
  return middle;
}

// For each cell, its vertex with many cells; if there are several, the one with the most; −1 if
// there is none.
std::vector<Vertex> hubs(const std::vector<Simplex>& cells) {
  std::map<Vertex, std::size_t> degree;
  for (const Simplex& cell : cells) {
    for (const Vertex v : cell) ++degree[v];
  }
  std::vector<Vertex> found;
  for (const Simplex& cell : cells) {
    Vertex hub = -1;
    for (const Vertex v : cell) {
      if (degree[v] >= kMany && (hub < 0 || degree[v] > degree[hub])) hub = v;
    }
    found.push_back(hub);
  }
  return found;
}

}  // namespace

CellIndex::CellIndex(const std::vector<Box>& boxes, const std::vector<Simplex>& vertices) {
  nodes_.reserve(2 * boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    nodes_.push_back({boxes[i], middle(boxes[i]), vertices[i], i, 0, true});
  }
  const std::vector<Vertex> hub_of = hubs(vertices);
  std::map<Vertex, std::vector<std::size_t>> at_hub;
  for (std::size_t i = 0; i < boxes.size(); ++i) at_hub[hub_of[i]].push_back(i);
  std::vector<std::size_t> trees;
  for (auto& [hub, cells] : at_hub) trees.push_back(joined(cells.begin(), cells.end()));
  if (!trees.empty()) joined(trees.begin(), trees.end());
}

// Joins nodes to a tree, and returns its root.
std::size_t CellIndex::joined(std::vector<std::size_t>::iterator first,
                              std::vector<std::size_t>::iterator last) {
  if (last - first == 1) return *first;
  std::array<double, 3> low = nodes_[*first].middle, high = low;
  for (auto node = first; node != last; ++node) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], nodes_[*node].middle[axis]);
      high[axis] = std::max(high[axis], nodes_[*node].middle[axis]);
    }
  }
  std::size_t axis = 0;
  for (const std::size_t other : {1, 2}) {
    if (high[other] - low[other] > high[axis] - low[axis]) axis = other;
  }
  const auto half = first + (last - first) / 2;
  std::nth_element(first, half, last, [&](std::size_t a, std::size_t b) {
    return nodes_[a].middle[axis] < nodes_[b].middle[axis];
  });
  const std::size_t left = joined(first, half);
  const std::size_t right = joined(half, last);
  const Box box = box_around(nodes_[left].box, nodes_[right].box);
  nodes_.push_back(
      {box, middle(box), in_both(nodes_[left].shared, nodes_[right].shared), left, right, false});
  return nodes_.size() - 1;
}

std::vector<std::size_t> CellIndex::apart(const Box& box,
                                          const std::vector<Vertex>& vertices) const {
  std::vector<std::size_t> found;
  if (nodes_.empty()) return found;
  std::vector<std::size_t> pending = {nodes_.size() - 1};
  while (!pending.empty()) {
    const Node& node = nodes_[pending.back()];
    pending.pop_back();
    ++work_;
    if (!may_meet_inside(box, node.box) || has_one_of(node.shared, vertices)) continue;
    if (node.is_leaf) {
      found.push_back(node.cell);
    } else {
      pending.insert(pending.end(), {node.cell, node.other});
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace circumspect
