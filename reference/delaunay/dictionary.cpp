#include "reference/delaunay/dictionary.hpp"

#include <algorithm>
#include <stdexcept>

namespace circumspect {

bool is_ghost(const Simplex& simplex) { return contains(simplex, kGhost); }

void SimplexDictionary::add(const Simplex& simplex) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
    if (!apex_in_front_.insert(facet, simplex[place])) {
      throw std::logic_error("SimplexDictionary::add: a facet already has a simplex on that side");
    }
    const std::size_t next = place + 1 < simplex.size() ? place + 1 : 0;
    const auto vertex = static_cast<std::size_t>(simplex[next] + 1);
    if (facet_at_vertex_.size() <= vertex) facet_at_vertex_.resize(vertex + 1);
    facet_at_vertex_[vertex] = facet;
  }
  ++size_;
}

void SimplexDictionary::remove(const Simplex& simplex) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
    if (apex_in_front_.find(facet) != simplex[place]) {
      throw std::logic_error("SimplexDictionary::remove: no such simplex");
    }
    apex_in_front_.erase(facet);
  }
  --size_;
}

std::optional<Vertex> SimplexDictionary::adjacent(const OrientedFacet& facet) const {
  return apex_in_front_.find(facet);
}

std::optional<Simplex> SimplexDictionary::adjacent_to_vertex(Vertex u) const {
  const auto place = static_cast<std::size_t>(u + 1);
  if (place >= facet_at_vertex_.size() || facet_at_vertex_[place].vertices.empty()) {
    return std::nullopt;
  }
  const OrientedFacet& recent = facet_at_vertex_[place];
  if (const auto apex = adjacent(recent)) return join(recent, *apex);
  return find([u](const Simplex& simplex) { return contains(simplex, u); });
}

std::optional<Simplex> SimplexDictionary::find(
    const std::function<bool(const Simplex&)>& condition) const {
  for (std::size_t slot = 0; slot < apex_in_front_.slots(); ++slot) {
    if (!apex_in_front_.is_entry(slot)) continue;
    const OrientedFacet facet = apex_in_front_.facet(slot);
    const Vertex apex = apex_in_front_.apex(slot);
    // Each simplex occurs once for each facet; it is reported where the apex is its largest vertex.
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
