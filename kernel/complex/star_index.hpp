// A triangulation that changes, with fast access to the star of every face. Book: Section 4.4
// ("every d-simplex in T with a face in T_D").
#pragma once

#include <map>
#include <set>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect {

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
