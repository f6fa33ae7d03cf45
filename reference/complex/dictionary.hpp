// The dictionary of a growing triangulation. Book: Section 5.1, Figure 5.1 (d = 3), Section 3.2
// (d = 2); here for any dimension k ≥ 1.
#pragma once

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "reference/complex/simplex.hpp"

namespace circumspect {

// The ghost vertex g: one symbolic vertex outside every hull facet. Book: Section 3.4.
inline constexpr Vertex kGhost = -1;
bool is_ghost(const Simplex& simplex);

// A facet with a front. In the plane and in space an order of the vertices says which side is the
// front; a single point (k = 1) has only one order, so the side is kept apart.
struct OrientedFacet {
  Simplex vertices;       // ascending
  bool reversed = false;  // is the front that of an odd permutation of `vertices`?

  // The face uvw of the book: the front is where x makes uvwx positively oriented.
  static OrientedFacet of(const Simplex& vertices_in_order);
  // The facet of a positively oriented simplex opposite one of its vertices, which is in front.
  static OrientedFacet opposite(const Simplex& simplex, std::size_t place);

  OrientedFacet reverse() const { return {vertices, !reversed}; }
  bool operator==(const OrientedFacet&) const = default;
};

// The simplex that joins a facet to an apex in front of it, positively oriented.
Simplex join(const OrientedFacet& facet, Vertex apex);

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

  // Adjacent2Vertex: some simplex that has u for a vertex; nothing if there is none. Looks first at
  // the simplex most recently added at u, and searches all when that one has been deleted since.
  std::optional<Simplex> adjacent_to_vertex(Vertex u) const;

  // Some simplex that satisfies a condition, found by a linear scan; nothing if none does.
  std::optional<Simplex> find(const std::function<bool(const Simplex&)>& condition) const;

  // All simplices, each once, with ascending facets deciding the order: the same for the same
  // contents on every machine.
  std::vector<Simplex> simplices() const;
  std::size_t size() const { return size_; }

 private:
  struct Hash {
    std::size_t operator()(const OrientedFacet& facet) const;
  };
  std::unordered_map<OrientedFacet, Vertex, Hash> apex_in_front_;
  std::unordered_map<Vertex, OrientedFacet> facet_at_vertex_;
  std::size_t size_ = 0;
};

}  // namespace circumspect
