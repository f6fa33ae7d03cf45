// Which cells of a complex may meet one with which they share no vertex. For speed alone: the boxes of
// n cells at one vertex all meet, and of their n² pairs none needs a look. Without it, `validated` of
// a double cone over a rim of 4,000 vertices takes 14 s, with it 0.6 s.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/kernel/complex/simplex.hpp"
#include "reference/kernel/exact/box_index.hpp"

namespace circumspect {

// A binary tree of cells. A node knows a box around its cells and the vertices that all of them share.
// The cells at a vertex of many are a tree of their own, so that this tree is passed over as a whole.
class CellIndex {
 public:
  // The box of each cell, and vertices of it, ascending.
  CellIndex(const std::vector<Box>& boxes, const std::vector<Simplex>& vertices);

  // The places in the list of all cells whose boxes may meet this one, and that have none of these
  // vertices, ascending. Requires: the vertices are in ascending order.
  std::vector<std::size_t> apart(const Box& box, const std::vector<Vertex>& vertices) const;

  // How many nodes all calls of `apart` have looked at.
  std::size_t work() const { return work_; }

 private:
  struct Node {
    Box box;
    std::array<double, 3> middle;  // of the box, doubled
    Simplex shared;  // vertices that all cells have; those of a single cell are all of its own
    std::size_t cell, other;  // a leaf: its place in the list; else the two nodes below it
    bool is_leaf;
  };

  std::size_t joined(std::vector<std::size_t>::iterator first,
                     std::vector<std::size_t>::iterator last);

  std::vector<Node> nodes_;  // children come before their parents
  mutable std::size_t work_ = 0;
};

}  // namespace circumspect
