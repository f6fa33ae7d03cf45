#include "oracle/judge/complex/adjacency.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/complex/by_facet.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"

namespace circumspect::check {
namespace {

using Uses = std::span<const FacetUse>;

// The simplices at each vertex, where those with a common facet at it are joined.
class Stars {
 public:
  Stars(const std::vector<Simplex>& simplices, const std::vector<FacetUse>& uses)
      : simplices_(simplices), joined_(simplices.empty() ? 0 : simplices.size() * size()) {
    for (const auto group : ByFacet(uses)) {
      for (std::size_t i = 1; i < group.size(); ++i) {
        for (const Vertex v : group[0].facet) {
          joined_.unite(place(group[0].simplex, v), place(group[i].simplex, v));
        }
      }
    }
  }

  // In how many parts the simplices at each vertex are.
  std::map<Vertex, std::size_t> parts() {
    std::map<Vertex, std::size_t> parts;
    for (std::size_t s = 0; s < simplices_.size(); ++s) {
      for (const Vertex v : simplices_[s]) {
        const std::size_t here = place(s, v);
        parts[v] += joined_.find(here) == here ? 1 : 0;
      }
    }
    return parts;
  }

 private:
  std::size_t size() const { return simplices_.front().size(); }
  std::size_t place(std::size_t s, Vertex v) const {
    const Simplex& simplex = simplices_[s];
    const auto at = std::find(simplex.begin(), simplex.end(), v) - simplex.begin();
    return s * size() + static_cast<std::size_t>(at);
  }

  const std::vector<Simplex>& simplices_;
  DisjointSets joined_;
};

// In which sense a simplex goes around a facet.
bool sense(const std::vector<Simplex>& simplices, const FacetUse& use) {
  const Simplex facet = facet_opposite(simplices[use.simplex], use.opposite);
  return is_odd_permutation(facet) != (use.opposite % 2 == 1);
}

void add_vertices(const std::vector<Simplex>& faces, std::set<Vertex>& vertices) {
  for (const Simplex& face : faces) vertices.insert(face.begin(), face.end());
}

}  // namespace

std::vector<Simplex> open_facets(const std::vector<FacetUse>& uses) {
  std::vector<Simplex> open;
  for (const auto group : ByFacet(uses)) {
    if (group.size() == 1) open.push_back(group.front().facet);
  }
  return open;
}

std::vector<std::size_t> part_of_each(const std::vector<Simplex>& simplices,
                                      const std::vector<FacetUse>& uses) {
  DisjointSets joined(simplices.size());
  for (const auto group : ByFacet(uses)) {
    for (const FacetUse& use : group) joined.unite(use.simplex, group.front().simplex);
  }
  std::vector<std::size_t> parts;
  parts.reserve(simplices.size());
  for (std::size_t s = 0; s < simplices.size(); ++s) parts.push_back(joined.find(s));
  return parts;
}

std::vector<Simplex> inconsistent_facets(const std::vector<Simplex>& simplices,
                                         const std::vector<FacetUse>& uses) {
  std::vector<Simplex> found;
  for (const auto group : ByFacet(uses)) {
    const bool goes_around = !group.front().facet.empty();
    if (group.size() != 2 || !goes_around) continue;
    if (sense(simplices, group[0]) == sense(simplices, group[1])) {
      found.push_back(group.front().facet);
    }
  }
  return found;
}

definition::NotManifold not_manifold(const std::vector<Simplex>& simplices,
                                     const std::vector<FacetUse>& uses) {
  definition::NotManifold found;
  if (simplices.empty()) return found;
  const std::size_t size = simplices.front().size();
  std::set<Simplex> ridges_of_named;
  for (const auto group : ByFacet(uses)) {
    if (group.size() < 3) continue;
    found.facets.push_back(group.front().facet);
    for (std::size_t i = 0; i < size - 1; ++i) {
      ridges_of_named.insert(facet_opposite(group.front().facet, i));
    }
  }
  const std::vector<Simplex> boundary = open_facets(uses);
  const std::vector<FacetUse> ridges = size > 2 ? facet_uses(boundary) : std::vector<FacetUse>();
  for (const auto group : ByFacet(ridges)) {
    const Simplex& ridge = group.front().facet;
    if (group.size() != 2 && !ridges_of_named.contains(ridge)) found.ridges.push_back(ridge);
  }
  if (size < 3) return found;
  std::set<Vertex> named;
  add_vertices(found.facets, named);
  add_vertices(found.ridges, named);
  std::map<Vertex, std::size_t> circles;
  if (size == 4) circles = Stars(boundary, ridges).parts();
  for (const auto& [vertex, count] : Stars(simplices, uses).parts()) {
    const auto circle = circles.find(vertex);
    const bool has_one_circle = circle == circles.end() || circle->second == 1;
    if (!named.contains(vertex) && (count != 1 || !has_one_circle)) {
      found.vertices.push_back(vertex);
    }
  }
  return found;
}

}  // namespace circumspect::check
