// The dictionary of Section 5.1: facets, and the simplices at them.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "kernel/complex/simplex.hpp"

namespace circumspect {

// ---- Facet table ----
// The hash table under the dictionary. Book: Section 5.1 ("store each tetrahedron four times in a
// hash table, keyed on the oriented faces"). It is here for speed alone: with std::unordered_map in its
// place `build delaunay` takes 45 % longer for 1,000 random points, and 180 % for 10,000.

// From oriented facets, all with the same number of vertices, to the apex in front of each. All
// entries lie in one array, each in the first free slot from its hash value on ("open addressing
// with linear probing": D. Knuth, The Art of Computer Programming 3, Section 6.4): a triangulation
// of 100,000 points has three million, too many for an allocation each.
class FacetTable {
 public:
  // False, and nothing changes, if the facet has an apex.
  bool insert(const OrientedFacet& facet, Vertex apex);
  // Requires: the facet has an apex.
  void erase(const OrientedFacet& facet);
  std::optional<Vertex> find(const OrientedFacet& facet) const;

  // The slots, for going through all entries; each is an entry or empty.
  std::size_t slots() const { return slots_; }
  bool is_entry(std::size_t slot) const { return *at(slot) != kEmpty; }
  OrientedFacet facet(std::size_t slot) const;
  Vertex apex(std::size_t slot) const { return at(slot)[width_ - 1]; }

 private:
  // A slot is a row of numbers: a tag, the vertices of the facet, the apex.
  static constexpr Vertex kEmpty = 0;
  static constexpr Vertex kForward = 1;
  static constexpr Vertex kReversed = 2;
  const Vertex* at(std::size_t slot) const { return &rows_[slot * width_]; }
  Vertex* at(std::size_t slot) { return &rows_[slot * width_]; }

  std::size_t home(const Vertex* row) const;
  std::size_t slot_of(const Vertex* row) const;
  void grow();

  std::size_t width_ = 0;
  std::size_t slots_ = 0;  // zero or a power of two
  std::size_t size_ = 0;
  std::vector<Vertex> rows_;
};

// ---- Dictionary ----
// The dictionary of a growing triangulation. Book: Section 5.1, Figure 5.1 (d = 3), Section 3.2
// (d = 2); here for any dimension k ≥ 1. And that of unfinished facets. Book: Sections 3.11 and 5.6.

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
  FacetTable apex_in_front_;
  // For vertex v, in place v + 1 (the ghost comes first), a facet of the simplex added last at v
  // that has v for a vertex; empty if there never was one.
  std::vector<OrientedFacet> facet_at_vertex_;
  std::size_t size_ = 0;
};

// The facets of a growing triangulation that have a simplex on one side only ("maintains a
// dictionary of unfinished … facets"). Each is oriented so that its front is the side on which a
// simplex is missing. The facets on the boundary of the convex hull are among them until they are
// taken off.
class UnfinishedFacets {
 public:
  void add(const OrientedFacet& facet) { facets_.insert(facet); }
  void remove(const OrientedFacet& facet) { facets_.erase(facet); }
  bool empty() const { return facets_.empty(); }
  // The first in order of the vertices. Requires: not empty.
  OrientedFacet first() const { return *facets_.begin(); }
  std::vector<OrientedFacet> all() const { return {facets_.begin(), facets_.end()}; }

  // A simplex has been constructed: each of its facets finishes an unfinished one, or is unfinished
  // now on the side that the simplex is not on. Requires: the simplex is positively oriented.
  void adjoin(const Simplex& simplex);

 private:
  struct Order {
    bool operator()(const OrientedFacet& a, const OrientedFacet& b) const {
      return a.vertices != b.vertices ? a.vertices < b.vertices : a.reversed < b.reversed;
    }
  };
  std::set<OrientedFacet, Order> facets_;
};

}  // namespace circumspect
