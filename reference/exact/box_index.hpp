// Which of many boxes meet a given one? An R-tree, so that the cells of a complex need not be held
// against each other two by two.
#pragma once

#include <memory>
#include <vector>

#include "reference/exact/enclosing_box.hpp"

namespace circumspect {

// The work is that of Boost.Geometry's R-tree, packed once, on three axes. It has doubles for coordinates, which a
// filter may have: boxes are rounded outward, and what a query finds is judged by exact predicates.
class BoxIndex {
 public:
  explicit BoxIndex(const std::vector<Box>& boxes);
  ~BoxIndex();
  BoxIndex(BoxIndex&&) noexcept;
  BoxIndex& operator=(BoxIndex&&) noexcept;

  // The places in the list of all boxes that may meet this one, ascending.
  std::vector<std::size_t> meeting(const Box& box) const;

  // A box that is near this one: a good guess, not certainly the nearest. Requires: there is a box.
  std::size_t near(const Box& box) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace circumspect
