// Triangulations, and the simplices at each of their vertices.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "kernel/complex/simplex.hpp"

namespace circumspect {

// ---- Triangulation ----
// A triangulation as a set of simplices. Book: Definition 2.1, Section 4.1.

// A k-dimensional triangulation, given by its k-simplices: each with its vertices ascending, the
// simplices in lexicographic order, so that two triangulations are the same set of simplices iff
// they compare equal. The lower-dimensional simplices are the faces of these.
class Triangulation {
 public:
  // Requires: every simplex has dimension + 1 distinct vertices; no simplex twice. Dimension −1,
  // without simplices, is the triangulation of the empty set.
  Triangulation(int dimension, std::vector<Simplex> simplices);

  int dimension() const { return dimension_; }
  const std::vector<Simplex>& simplices() const { return simplices_; }
  bool operator==(const Triangulation&) const = default;

  bool has(const Simplex& simplex) const;

 private:
  int dimension_;
  std::vector<Simplex> simplices_;
};

// Facet look-up: for each facet (ascending vertices) the vertices opposite to it, one for each
// simplex that has it. In a triangulation one (on the hull) or two.
std::map<Simplex, std::vector<Vertex>> apexes_by_facet(const Triangulation& triangulation);

// ---- Star index ----
// A triangulation that changes, with fast access to the star of every face. Book: Section 4.4
// ("every d-simplex in T with a face in T_D").

// A set of simplices of one dimension, filed under each of their vertices. Simplices and faces may
// be named with their vertices in any order; they are returned ascending.
class StarIndex {
 public:
  explicit StarIndex(const std::vector<Simplex>& simplices);

  bool has(const Simplex& simplex) const;

  // The star of a face: all simplices that have it as a face, in lexicographic order; for the empty
  // face, all simplices. Looks through the simplices at the vertex that has the fewest.
  std::vector<Simplex> star(const Simplex& face) const;

  // The link of a face: every ζ such that face * ζ is a simplex here. Just the empty simplex if the
  // face is itself one of them.
  std::vector<Simplex> link(const Simplex& face) const;

  // Takes simplices out and puts others in. Throws std::logic_error if one of the former is
  // missing, or one of the latter is already there.
  void replace(const std::vector<Simplex>& deleted, const std::vector<Simplex>& created);

  std::size_t size() const { return simplices_.size(); }
  const std::set<Simplex>& simplices() const { return simplices_; }

  // Requires: every simplex has dimension + 1 vertices.
  Triangulation triangulation(int dimension) const;

 private:
  void add(const Simplex& simplex);
  void remove(const Simplex& simplex);

  std::set<Simplex> simplices_;
  std::map<Vertex, std::set<Simplex>> at_vertex_;
};

// The facets of some simplices, each once, in lexicographic order.
std::vector<Simplex> facets_of(const std::vector<Simplex>& simplices);

// The join σ * ζ of two disjoint simplices: the simplex with the vertices of both, ascending.
Simplex join(const Simplex& simplex, const Simplex& other);

// The vertices of a simplex, ascending, without those of a face of it.
Simplex without(const Simplex& simplex, const Simplex& face);

}  // namespace circumspect
