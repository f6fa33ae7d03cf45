// The dictionary of a growing triangulation. Book: Section 5.1, Figure 5.1 (d = 3), Section 3.2
// (d = 2); here for any dimension k ≥ 1.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "reference/delaunay/facet_table.hpp"

namespace circumspect {

// The ghost vertex g: one symbolic vertex outside every hull facet. Book: Section 3.4.
inline constexpr Vertex kGhost = -1;
bool is_ghost(const Simplex& simplex);

// Book: Figure 5.1. Every simplex is stored once for each of its facets, keyed on the facet with
// the simplex in front. Simplices are given by their vertices with positive orientation, one of
// which may be the ghost vertex.
class SimplexDictionary {
 public:
  // AddTetrahedron. Throws std::logic_error if one of its facets already has a simplex on that
  // side: "only two tetrahedra may adjoin a triangular face, and only one on each side".
  void add(const Simplex& simplex);

  // DeleteTetrahedron. Throws std::logic_error if it is not there.
  void remove(const Simplex& simplex);

  // Adjacent: the vertex x such that facet and x form a simplex in front of the facet; nothing if
  // there is none.
  std::optional<Vertex> adjacent(const OrientedFacet& facet) const;

  // Adjacent2Vertex: some simplex that has the vertex u; nothing if there is none. Looks first at
  // the simplex most recently added at u, and searches all if that one has been deleted since.
  std::optional<Simplex> adjacent_to_vertex(Vertex u) const;

  // Some simplex that satisfies a condition, found by a linear scan; nothing if none does.
  std::optional<Simplex> find(const std::function<bool(const Simplex&)>& condition) const;

  // All simplices, each once, in ascending order of facets, so that the same contents give the same
  // list on every machine.
  std::vector<Simplex> simplices() const;
  std::size_t size() const { return size_; }

 private:
  FacetTable apex_in_front_;
  // For vertex v, in place v + 1 (the ghost comes first), a facet of the simplex added last at v
  // that has v for a vertex; empty if there never was one.
  std::vector<OrientedFacet> facet_at_vertex_;
  std::size_t size_ = 0;
};

}  // namespace circumspect
