// Sets that are merged, one after another.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace circumspect {

// A partition of 0, 1, …, size − 1, at first into single elements (R. Tarjan, J. ACM 22, 1975).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  // One element for each set, the same for all of its elements.
  std::size_t find(std::size_t element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }
  void unite(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace circumspect
