#include "reference/kernel/complex/facets.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace circumspect {

// ---- Oriented facets ----

OrientedFacet OrientedFacet::of(const Simplex& vertices_in_order) {
  return {sorted(vertices_in_order), is_odd_permutation(vertices_in_order)};
}

OrientedFacet OrientedFacet::opposite(const Simplex& simplex, std::size_t place) {
  OrientedFacet facet = of(facet_opposite(simplex, place));
  // Bringing the apex to the end takes one transposition for each vertex behind it.
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

// ---- Which simplices have a facet ----

std::vector<FacetUse> facet_uses(const std::vector<Simplex>& simplices) {
  std::vector<FacetUse> uses;
  uses.reserve(simplices.empty() ? 0 : simplices.size() * simplices.front().size());
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    for (std::size_t place = 0; place < simplices[s].size(); ++place) {
      uses.push_back({sorted(facet_opposite(simplices[s], place)), s, place});
    }
  }
  // The least vertex, which decides most comparisons, stands beside the place of each use.
  std::vector<std::pair<Vertex, std::size_t>> order;
  order.reserve(uses.size());
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const Simplex& facet = uses[i].facet;
    order.emplace_back(facet.empty() ? std::numeric_limits<Vertex>::min() : facet.front(), i);
  }
  std::sort(order.begin(), order.end(), [&uses](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    const auto difference = uses[a.second].facet <=> uses[b.second].facet;
    return difference != 0 ? difference < 0 : a.second < b.second;
  });
  std::vector<FacetUse> in_order;
  in_order.reserve(uses.size());
  for (const auto& [least, place] : order) in_order.push_back(std::move(uses[place]));
  return in_order;
}

void for_each_facet(const std::vector<FacetUse>& uses,
                    const std::function<void(std::span<const FacetUse>)>& visit) {
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = std::find_if(first, uses.end(),
                                   [&](const FacetUse& use) { return use.facet != first->facet; });
    visit({first, last});
    first = last;
  }
}

}  // namespace circumspect
