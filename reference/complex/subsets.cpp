#include "reference/complex/subsets.hpp"

#include <numeric>

namespace circumspect {

Simplex first_subset(std::size_t size) {
  Simplex subset(size);
  std::iota(subset.begin(), subset.end(), Vertex{0});
  return subset;
}

bool next_subset(Simplex& subset, std::size_t n) {
  std::size_t i = subset.size();
  // The last place that is not at its largest possible value, n − (how many follow, itself too).
  while (i > 0 && subset[i - 1] == static_cast<Vertex>(n - subset.size() + i - 1)) --i;
  if (i == 0) return false;
  std::iota(subset.begin() + static_cast<Vertex>(i) - 1, subset.end(), subset[i - 1] + 1);
  return true;
}

}  // namespace circumspect
