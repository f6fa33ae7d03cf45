// Simplices and their facets: vertices, their order, and orientations.
#pragma once

#include <compare>
#include <vector>

#include "kernel/predicates/configuration.hpp"

namespace circumspect {

// The vertices of a simplex, in the order given. A user's simplex is meant as a set; where
// orientation matters, the order carries it.
using Simplex = std::vector<Vertex>;

// The same set of vertices in ascending order.
Simplex sorted(Simplex simplex);

// The facet opposite vertex number `place`: all other vertices, in their order.
Simplex facet_opposite(const Simplex& simplex, std::size_t place);

// The simplex that joins a facet to an apex, which becomes its last vertex.
Simplex with_apex(Simplex facet, Vertex apex);

// The simplex with vertex number `place` replaced.
Simplex with_vertex_replaced(Simplex simplex, std::size_t place, Vertex vertex);

bool contains(const Simplex& simplex, Vertex vertex);
// Are all vertices of `face` vertices of the simplex?
bool has_face(const Simplex& simplex, const Simplex& face);
// How many of the simplices have this face?
std::size_t count_with_face(const std::vector<Simplex>& simplices, const Simplex& face);
bool has_repeated_vertex(const Simplex& simplex);

// Is the permutation that sorts the vertices odd? Requires: no repeated vertex.
bool is_odd_permutation(const Simplex& simplex);

// {0, 1, …, size − 1}.
Simplex first_subset(std::size_t size);

// Turns a subset of {0, …, n−1}, in ascending order, into the next one of the same size in
// lexicographic order; false after the last.
bool next_subset(Simplex& subset, std::size_t n);

// The faces with `size` vertices, each in the order of the simplex; and all faces, the smaller
// first, the simplex itself last.
std::vector<Simplex> faces(const Simplex& simplex, std::size_t size);
std::vector<Simplex> faces(const Simplex& simplex);

// The faces with `size` vertices of some simplices: ascending, each once, in lexicographic order.
std::vector<Simplex> faces_of(const std::vector<Simplex>& simplices, std::size_t size);

// Facets: with a front and a back (Book: Section 5.1, "oriented triangular face"), and which
// simplices of a list have them.

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
  // The orientation of the vertices with a point in front as the last one.
  int front() const { return reversed ? -1 : 1; }
  bool operator==(const OrientedFacet&) const = default;
  std::strong_ordering operator<=>(const OrientedFacet& other) const {
    const std::strong_ordering order = vertices <=> other.vertices;
    return order != 0 ? order : front() <=> other.front();
  }
};

// The simplex that joins a facet to an apex in front of it, positively oriented.
Simplex join(const OrientedFacet& facet, Vertex apex);

// One simplex's use of a facet.
struct FacetUse {
  Simplex facet;         // its vertices, ascending
  std::size_t simplex;   // which simplex of the list has it for a face
  std::size_t opposite;  // the place of the vertex that the facet leaves out
};

// All uses, in order of the facets' vertices and then of the simplices, so that the uses of one
// facet are adjacent. Book: Section 4.2 ("a facet of a triangulation is a (d−1)-simplex").
std::vector<FacetUse> facet_uses(const std::vector<Simplex>& simplices);

}  // namespace circumspect
