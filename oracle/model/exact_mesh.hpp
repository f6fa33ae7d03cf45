// Indices as users list them, and meshes of exact numbers in lists, which the checkers that are
// written for clarity judge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/configuration.hpp"

namespace circumspect {

// Indices as users list them, and places from 0. The arithmetic is modulo 2^64: every index of 64
// bits then has a place of its own, can be recovered from it, and has the place of a point only if
// it names one. An index that wraps around names no point, because the indices of all points fit 64
// bits.

static_assert(sizeof(Vertex) == sizeof(std::uint64_t));

// The place of what a user calls `index` and counts from `first_index`.
constexpr Vertex place_of_index(Vertex index, Vertex first_index) {
  return static_cast<Vertex>(static_cast<std::uint64_t>(index) -
                             static_cast<std::uint64_t>(first_index));
}

// The user's index of the item at a place.
constexpr Vertex index_of_place(Vertex place, Vertex first_index) {
  return static_cast<Vertex>(static_cast<std::uint64_t>(place) +
                             static_cast<std::uint64_t>(first_index));
}

// Do the indices of so many items, counted from `first_index`, fit 64 bits?
constexpr bool has_room(Vertex first_index, std::size_t count) {
  const std::uint64_t after_first = static_cast<std::uint64_t>(std::numeric_limits<Vertex>::max()) -
                                    static_cast<std::uint64_t>(first_index);
  return count == 0 || count - 1 <= after_first;
}

// A mesh of exact numbers and lists, which the checkers that are written for clarity judge and
// constructions are compared with. A mesh that was read (mesh.hpp) is converted to it where needed.

// Which simplex is across the facet opposite each vertex, as a program lists it.
struct Neighbors {
  // One row a simplex, one entry a vertex: the index of a simplex, counted from first_index, or −1.
  std::vector<std::vector<Vertex>> rows;
  Vertex first_index = 0;
};

// Simplices name points by their index from 0; an index that names no point stays in place, for the
// checker to report. `labels` translates back: the user's own index of each point.
struct ExactMesh {
  PointSet points;
  std::vector<Simplex> simplices;
  std::vector<Vertex> labels = {};  // empty: the index itself
  Vertex first_index = 0;           // the user's index of the first point, and of the first simplex
  std::optional<Neighbors> neighbors = {};
  // Triangles and edges that a program lists beside the simplices (.face, .edge), each with fewer
  // vertices than a simplex. Those that are faces of no simplex with more vertices dangle; the
  // others add nothing. Only claims about a domain use them, and `complex` if they are to be faces.
  std::vector<Simplex> faces = {};

  std::vector<Simplex> simplices_and_faces() const {
    std::vector<Simplex> all = simplices;
    all.insert(all.end(), faces.begin(), faces.end());
    return all;
  }

  // The user's own index of a vertex, whether it names a point or not.
  Vertex label(Vertex v) const {
    if (!points.names(v) || labels.empty()) return index_of_place(v, first_index);
    return labels[static_cast<std::size_t>(v)];
  }
};

}  // namespace circumspect
