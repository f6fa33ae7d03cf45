#include "oracle/model/periodic_facets.hpp"

#include <algorithm>
#include <tuple>

namespace circumspect {

Simplex sum(const Simplex& a, const Simplex& b) {
  Simplex all = a;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] += b[i];
  return all;
}

Simplex difference(const Simplex& a, const Simplex& b) {
  Simplex all = a;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] -= b[i];
  return all;
}

std::vector<FacetPlace> facet_places(const std::vector<PeriodicCell>& cells) {
  std::vector<FacetPlace> places;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    for (std::size_t opposite = 0; opposite < cells[cell].size(); ++opposite) {
      PeriodicCell facet = cells[cell];
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(opposite));
      // Moving all vertices alike does not change which comes first.
      std::sort(facet.begin(), facet.end());
      const Simplex moved = facet.front().offset;
      for (MovedPoint& vertex : facet) vertex.offset = difference(vertex.offset, moved);
      places.push_back({std::move(facet), cell, opposite, moved});
    }
  }
  std::sort(places.begin(), places.end(), [](const FacetPlace& a, const FacetPlace& b) {
    return std::tie(a.facet, a.cell, a.opposite) < std::tie(b.facet, b.cell, b.opposite);
  });
  return places;
}

}  // namespace circumspect
