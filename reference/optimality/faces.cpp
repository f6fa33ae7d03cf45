#include "reference/optimality/faces.hpp"

#include <set>

#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::optimality {

std::vector<Simplex> faces(const Simplex& simplex) {
  std::vector<Simplex> all;
  for (std::size_t size = 1; size <= simplex.size(); ++size) {
    Simplex places = first_subset(size);
    do {
      Simplex face;
      for (const Vertex place : places) face.push_back(simplex[static_cast<std::size_t>(place)]);
      all.push_back(face);
    } while (next_subset(places, simplex.size()));
  }
  return all;
}

std::vector<Simplex> simplicial_complex(const Triangulation& triangulation) {
  const auto by_dimension = [](const Simplex& a, const Simplex& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  };
  std::set<Simplex, decltype(by_dimension)> all(by_dimension);
  for (const Simplex& simplex : triangulation.simplices()) {
    for (const Simplex& face : faces(simplex)) all.insert(face);
  }
  return {all.begin(), all.end()};
}

}  // namespace circumspect::optimality
