#include "reference/delaunay/conflict_graph.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/predicates/place.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {

// The simplices that an insertion deleted, as the graph that the search traverses.
class Cavity {
 public:
  // What is on the other side of a facet of a deleted simplex: another deleted simplex or, at a
  // facet of the cavity, the simplex created there and the one that stayed beyond it.
  struct Side {
    std::optional<std::size_t> deleted;
    Simplex created;
    Simplex beyond;
  };

  Cavity(const Insertion& insertion, const SimplexDictionary& triangulation)
      : simplices_(insertion.deleted), sides_(simplices_.size()) {
    for (const auto group : ByFacet(facet_uses(simplices_))) {
      if (group.size() == 2) {
        sides_[group[0].simplex].push_back({.deleted = group[1].simplex, .created{}, .beyond{}});
        sides_[group[1].simplex].push_back({.deleted = group[0].simplex, .created{}, .beyond{}});
        continue;
      }
      const auto [ascending, owner, opposite] = group[0];
      const OrientedFacet facet = OrientedFacet::opposite(simplices_[owner], opposite);
      const Vertex beyond = triangulation.adjacent(facet.reverse()).value();
      sides_[owner].push_back({.deleted = std::nullopt,
                               .created = join(facet, insertion.vertex),
                               .beyond = join(facet.reverse(), beyond)});
    }
  }

  std::size_t size() const { return simplices_.size(); }
  const Simplex& simplex(std::size_t i) const { return simplices_[i]; }
  const std::vector<Side>& sides(std::size_t i) const { return sides_[i]; }

 private:
  const std::vector<Simplex>& simplices_;
  std::vector<std::vector<Side>> sides_;
};

std::size_t ConflictGraph::Hash::operator()(const Simplex& ascending) const {
  std::size_t hash = 0;
  for (const Vertex v : ascending) {
    hash = (hash ^ static_cast<std::size_t>(v)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return hash;
}

ConflictGraph::ConflictGraph(const PointSet& points, const SimplexDictionary& triangulation,
                             const std::vector<Vertex>& uninserted, Statistics& statistics)
    : points_(points),
      triangulation_(triangulation),
      statistics_(statistics),
      conflict_of_(points.size()) {
  const std::vector<Simplex> simplices = triangulation.simplices();
  for (const Vertex w : uninserted) {
    const auto found = std::find_if(simplices.begin(), simplices.end(),
                                    [&](const Simplex& simplex) { return has_room(simplex, w); });
    if (found != simplices.end()) file(w, *found);
  }
}

std::optional<Simplex> ConflictGraph::conflict_of(Vertex w) const {
  const Simplex& simplex = conflict_of_[static_cast<std::size_t>(w)];
  if (simplex.empty()) return std::nullopt;
  return simplex;
}

void ConflictGraph::update(const Insertion& insertion) {
  std::optional<Cavity> cavity;
  for (std::size_t i = 0; i < insertion.deleted.size(); ++i) {
    const auto filed = filed_with_.find(sorted(insertion.deleted[i]));
    if (filed == filed_with_.end()) continue;
    const std::vector<Vertex> vertices = std::move(filed->second);
    filed_with_.erase(filed);
    if (!cavity) cavity.emplace(insertion, triangulation_);
    for (const Vertex w : vertices) {
      conflict_of_[static_cast<std::size_t>(w)].clear();
      if (w == insertion.vertex) continue;
      const std::optional<Simplex> found = search(w, *cavity, i);
      assert(found || points_.is_weighted());
      if (found) file(w, *found);
    }
  }
}

void ConflictGraph::file(Vertex w, const Simplex& simplex) {
  ++statistics_.conflicts_created;
  filed_with_[sorted(simplex)].push_back(w);
  conflict_of_[static_cast<std::size_t>(w)] = simplex;
}

bool ConflictGraph::is_conflict(const Simplex& simplex, Vertex w) {
  ++statistics_.conflict_tests;
  return is_in_conflict(points_, simplex, w);
}

// May w be filed with the simplex? Without weights a solid simplex that contains w is in conflict
// with it.
bool ConflictGraph::has_room(const Simplex& simplex, Vertex w) {
  if (points_.is_weighted() || is_ghost(simplex)) return is_conflict(simplex, w);
  return lies_in(points_.configuration(), points_.configuration().axes(), simplex, w);
}

// A vertex that a solid simplex contains never needs a ghost again.
std::optional<Simplex> ConflictGraph::search(Vertex w, const Cavity& cavity, std::size_t start) {
  const bool may_be_outside = points_.is_weighted() || is_ghost(cavity.simplex(start));
  std::vector<bool> met(cavity.size());
  std::vector<std::size_t> pending = {start};
  met[start] = true;
  while (!pending.empty()) {
    const std::size_t current = pending.back();
    pending.pop_back();
    for (const Cavity::Side& side : cavity.sides(current)) {
      if (side.deleted) {
        if (met[*side.deleted]) continue;
        met[*side.deleted] = true;
        if (is_conflict(cavity.simplex(*side.deleted), w)) pending.push_back(*side.deleted);
        continue;
      }
      for (const Simplex* simplex : {&side.created, &side.beyond}) {
        const bool solid = !is_ghost(*simplex);
        // Without weights, w is in the cavity, outside or on the boundary, but not inside a simplex
        // that stayed.
        if (solid && simplex == &side.beyond && !points_.is_weighted()) continue;
        if (!solid && !may_be_outside) continue;
        if (has_room(*simplex, w)) return *simplex;
      }
    }
  }
  return std::nullopt;
}

}  // namespace circumspect::delaunay
