#include "oracle/judge/periodic/periodic_facets.hpp"

#include <algorithm>
#include <tuple>

namespace circumspect::check {

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
      PeriodicCell key = cells[cell];
      key.erase(key.begin() + static_cast<std::ptrdiff_t>(opposite));
      // Moving all vertices alike does not change which comes first.
      std::sort(key.begin(), key.end());
      const Simplex moved = key.front().offset;
      for (MovedPoint& vertex : key) vertex.offset = difference(vertex.offset, moved);
      places.push_back({std::move(key), cell, opposite, moved});
    }
  }
  std::sort(places.begin(), places.end(), [](const FacetPlace& a, const FacetPlace& b) {
    return std::tie(a.key, a.cell, a.opposite) < std::tie(b.key, b.cell, b.opposite);
  });
  return places;
}

void for_each_facet(const std::vector<FacetPlace>& places,
                    const std::function<void(std::span<const FacetPlace>)>& visit) {
  for (std::size_t begin = 0; begin < places.size();) {
    std::size_t end = begin;
    while (end < places.size() && places[end].key == places[begin].key) ++end;
    visit(std::span(places).subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace circumspect::check
