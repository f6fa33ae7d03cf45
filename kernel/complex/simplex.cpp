#include "kernel/complex/simplex.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "kernel/exact/each_once.hpp"

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

Simplex with_apex(Simplex facet, Vertex apex) {
  facet.push_back(apex);
  return facet;
}

Simplex with_vertex_replaced(Simplex simplex, std::size_t place, Vertex vertex) {
  simplex[place] = vertex;
  return simplex;
}

bool contains(const Simplex& simplex, Vertex vertex) {
  return std::find(simplex.begin(), simplex.end(), vertex) != simplex.end();
}

bool has_face(const Simplex& simplex, const Simplex& face) {
  return std::all_of(face.begin(), face.end(), [&](Vertex v) { return contains(simplex, v); });
}

std::size_t count_with_face(const std::vector<Simplex>& simplices, const Simplex& face) {
  return static_cast<std::size_t>(
      std::count_if(simplices.begin(), simplices.end(),
                    [&](const Simplex& simplex) { return has_face(simplex, face); }));
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
  // The last place that is not at its largest possible value, n − (the number of places from it to
  // the end).
  while (i > 0 && subset[i - 1] == static_cast<Vertex>(n - subset.size() + i - 1)) --i;
  if (i == 0) return false;
  std::iota(subset.begin() + static_cast<Vertex>(i) - 1, subset.end(), subset[i - 1] + 1);
  return true;
}

std::vector<Simplex> faces(const Simplex& simplex, std::size_t size) {
  std::vector<Simplex> found;
  if (simplex.size() < size) return found;
  Simplex places = first_subset(size);
  do {
    Simplex& face = found.emplace_back();
    for (const Vertex place : places) face.push_back(simplex[static_cast<std::size_t>(place)]);
  } while (next_subset(places, simplex.size()));
  return found;
}

std::vector<Simplex> faces(const Simplex& simplex) {
  std::vector<Simplex> all;
  for (std::size_t size = 1; size <= simplex.size(); ++size) {
    for (Simplex& face : faces(simplex, size)) all.push_back(std::move(face));
  }
  return all;
}

std::vector<Simplex> faces_of(const std::vector<Simplex>& simplices, std::size_t size) {
  std::vector<Simplex> found;
  for (const Simplex& simplex : simplices) {
    for (Simplex& face : faces(simplex, size)) found.push_back(sorted(std::move(face)));
  }
  keep_each_once(found);
  return found;
}

OrientedFacet OrientedFacet::of(const Simplex& vertices_in_order) {
  return {sorted(vertices_in_order), is_odd_permutation(vertices_in_order)};
}

OrientedFacet OrientedFacet::opposite(const Simplex& simplex, std::size_t place) {
  OrientedFacet facet = of(facet_opposite(simplex, place));
  // Moving the apex to the end takes one transposition for each vertex after it.
  const bool moves_are_odd = (simplex.size() - 1 - place) % 2 == 1;
  facet.reversed ^= moves_are_odd;
  return facet;
}

Simplex join(const OrientedFacet& facet, Vertex apex) {
  Simplex simplex = facet.vertices;
  simplex.push_back(apex);
  if (facet.reversed) std::swap(simplex[simplex.size() - 1], simplex[simplex.size() - 2]);
  return simplex;
}

std::vector<FacetUse> facet_uses(const std::vector<Simplex>& simplices) {
  std::vector<FacetUse> uses;
  uses.reserve(simplices.empty() ? 0 : simplices.size() * simplices.front().size());
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    for (std::size_t place = 0; place < simplices[s].size(); ++place) {
      uses.push_back({sorted(facet_opposite(simplices[s], place)), s, place});
    }
  }
  // The least vertex, which decides most comparisons, is stored beside the place of each use.
  std::vector<std::pair<Vertex, std::size_t>> order;
  order.reserve(uses.size());
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const Simplex& facet = uses[i].facet;
    order.emplace_back(facet.empty() ? std::numeric_limits<Vertex>::min() : facet.front(), i);
  }
  // Lists of simplices are often nearly in order, which costs `sort` most and `stable_sort` least.
  std::stable_sort(order.begin(), order.end(), [&uses](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : uses[a.second].facet < uses[b.second].facet;
  });
  std::vector<FacetUse> in_order;
  in_order.reserve(uses.size());
  for (const auto& [least, place] : order) in_order.push_back(std::move(uses[place]));
  return in_order;
}

}  // namespace circumspect
