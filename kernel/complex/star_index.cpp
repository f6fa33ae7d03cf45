#include "kernel/complex/star_index.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect {

StarIndex::StarIndex(const std::vector<Simplex>& simplices) {
  for (const Simplex& simplex : simplices) add(sorted(simplex));
}

bool StarIndex::has(const Simplex& simplex) const { return simplices_.count(sorted(simplex)) > 0; }

std::vector<Simplex> StarIndex::star(const Simplex& face) const {
  const Simplex ascending = sorted(face);
  const std::set<Simplex>* fewest = &simplices_;
  for (const Vertex v : ascending) {
    const auto at_v = at_vertex_.find(v);
    if (at_v == at_vertex_.end()) return {};
    if (at_v->second.size() < fewest->size()) fewest = &at_v->second;
  }
  std::vector<Simplex> simplices;
  std::copy_if(
      fewest->begin(), fewest->end(), std::back_inserter(simplices), [&](const Simplex& simplex) {
        return std::includes(simplex.begin(), simplex.end(), ascending.begin(), ascending.end());
      });
  return simplices;
}

std::vector<Simplex> StarIndex::link(const Simplex& face) const {
  std::vector<Simplex> simplices = star(face);
  for (Simplex& simplex : simplices) simplex = without(simplex, face);
  return simplices;
}

void StarIndex::replace(const std::vector<Simplex>& deleted, const std::vector<Simplex>& created) {
  for (const Simplex& simplex : deleted) remove(sorted(simplex));
  for (const Simplex& simplex : created) add(sorted(simplex));
}

void StarIndex::add(const Simplex& simplex) {
  if (!simplices_.insert(simplex).second) {
    throw std::logic_error("StarIndex: a simplex is there already");
  }
  for (const Vertex v : simplex) at_vertex_[v].insert(simplex);
}

void StarIndex::remove(const Simplex& simplex) {
  if (simplices_.erase(simplex) == 0) throw std::logic_error("StarIndex: no such simplex");
  for (const Vertex v : simplex) {
    const auto at_v = at_vertex_.find(v);
    at_v->second.erase(simplex);
    if (at_v->second.empty()) at_vertex_.erase(at_v);
  }
}

Triangulation StarIndex::triangulation(int dimension) const {
  return Triangulation(dimension, {simplices_.begin(), simplices_.end()});
}

std::vector<Simplex> facets_of(const std::vector<Simplex>& simplices) {
  std::set<Simplex> facets;
  for (const Simplex& simplex : simplices) {
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      facets.insert(sorted(facet_opposite(simplex, place)));
    }
  }
  return {facets.begin(), facets.end()};
}

Simplex join(const Simplex& simplex, const Simplex& other) {
  Simplex both = simplex;
  both.insert(both.end(), other.begin(), other.end());
  return sorted(std::move(both));
}

Simplex without(const Simplex& simplex, const Simplex& face) {
  Simplex rest;
  for (const Vertex v : simplex) {
    if (!contains(face, v)) rest.push_back(v);
  }
  return sorted(std::move(rest));
}

}  // namespace circumspect
