#include "reference/complex/simplex.hpp"

#include <algorithm>

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

}  // namespace circumspect
