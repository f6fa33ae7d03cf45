#include "kernel/complex/triangulation.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <vector>

#include "kernel/complex/simplex.hpp"

namespace circumspect {

Triangulation::Triangulation(int dimension, std::vector<Simplex> simplices)
    : dimension_(dimension), simplices_(std::move(simplices)) {
  for (Simplex& simplex : simplices_) {
    assert(static_cast<int>(simplex.size()) == dimension_ + 1);
    std::sort(simplex.begin(), simplex.end());
  }
  std::sort(simplices_.begin(), simplices_.end());
  assert(std::adjacent_find(simplices_.begin(), simplices_.end()) == simplices_.end());
}

bool Triangulation::has(const Simplex& simplex) const {
  return std::binary_search(simplices_.begin(), simplices_.end(), sorted(simplex));
}

std::map<Simplex, std::vector<Vertex>> apexes_by_facet(const Triangulation& triangulation) {
  std::map<Simplex, std::vector<Vertex>> apexes;
  for (const Simplex& simplex : triangulation.simplices()) {
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      apexes[facet_opposite(simplex, place)].push_back(simplex[place]);
    }
  }
  return apexes;
}

}  // namespace circumspect
