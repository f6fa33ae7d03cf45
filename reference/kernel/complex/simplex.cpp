#include "reference/kernel/complex/simplex.hpp"

#include <algorithm>
#include <numeric>

namespace circumspect {

Simplex sorted(Simplex simplex) {
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

Simplex facet_opposite(const Simplex& simplex, std::size_t place) {
  Simplex facet;
  facet.reserve(simplex.size() - 1);
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    if (i != place) facet.push_back(simplex[i]);
  }
  return facet;
}

Simplex with_vertex_replaced(Simplex simplex, std::size_t place, Vertex vertex) {
  simplex[place] = vertex;
  return simplex;
}

bool contains(const Simplex& simplex, Vertex vertex) {
  return std::find(simplex.begin(), simplex.end(), vertex) != simplex.end();
}

bool has_repeated_vertex(const Simplex& simplex) {
  const Simplex ascending = sorted(simplex);
  return std::adjacent_find(ascending.begin(), ascending.end()) != ascending.end();
}

bool is_odd_permutation(const Simplex& simplex) {
  bool odd = false;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    for (std::size_t j = i + 1; j < simplex.size(); ++j) odd ^= simplex[j] < simplex[i];
  }
  return odd;
}

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
