#include "reference/complex/dictionary.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace circumspect {

bool is_ghost(const Simplex& simplex) { return contains(simplex, kGhost); }

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

std::size_t SimplexDictionary::Hash::operator()(const OrientedFacet& facet) const {
  std::size_t hash = facet.reversed ? 1 : 0;
  for (const Vertex v : facet.vertices) {
    // The 64-bit finaliser of MurmurHash3, one round a vertex.
    hash ^= static_cast<std::size_t>(v) + 0x9e3779b97f4a7c15u;
    hash *= 0xff51afd7ed558ccdu;
    hash ^= hash >> 33;
  }
  return hash;
}

void SimplexDictionary::add(const Simplex& simplex) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
    if (!apex_in_front_.emplace(facet, simplex[place]).second) {
      throw std::logic_error("SimplexDictionary::add: a facet already has a simplex on that side");
    }
    for (const Vertex v : facet.vertices) facet_at_vertex_[v] = facet;
  }
  ++size_;
}

void SimplexDictionary::remove(const Simplex& simplex) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const auto entry = apex_in_front_.find(OrientedFacet::opposite(simplex, place));
    if (entry == apex_in_front_.end() || entry->second != simplex[place]) {
      throw std::logic_error("SimplexDictionary::remove: no such simplex");
    }
    apex_in_front_.erase(entry);
  }
  --size_;
}

std::optional<Vertex> SimplexDictionary::adjacent(const OrientedFacet& facet) const {
  const auto entry = apex_in_front_.find(facet);
  if (entry == apex_in_front_.end()) return std::nullopt;
  return entry->second;
}

std::optional<Simplex> SimplexDictionary::adjacent_to_vertex(Vertex u) const {
  const auto recent = facet_at_vertex_.find(u);
  if (recent == facet_at_vertex_.end()) return std::nullopt;
  if (const auto apex = adjacent(recent->second)) return join(recent->second, *apex);
  for (const auto& [facet, apex] : apex_in_front_) {
    if (contains(facet.vertices, u)) return join(facet, apex);
  }
  return std::nullopt;
}

std::optional<Simplex> SimplexDictionary::find(
    const std::function<bool(const Simplex&)>& condition) const {
  for (const auto& [facet, apex] : apex_in_front_) {
    // Each simplex is met once for each facet; look at it where the apex is its largest vertex.
    if (apex < facet.vertices.back()) continue;
    if (Simplex simplex = join(facet, apex); condition(simplex)) return simplex;
  }
  return std::nullopt;
}

std::vector<Simplex> SimplexDictionary::simplices() const {
  std::vector<Simplex> all;
  all.reserve(size_);
  find([&](const Simplex& simplex) {
    all.push_back(simplex);
    return false;
  });
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace circumspect
