// A mesh of exact numbers and of lists: what the checkers judge that are written for clarity, and what
// constructions are compared with. Of a mesh that was read (mesh.hpp) one is made where it is needed.
#pragma once

#include <optional>
#include <vector>

#include "oracle/model/listed_index.hpp"
#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect {

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
  // Triangles and edges that a program lists beside (.face, .edge), each of fewer vertices than a
  // simplex above. Those that are faces of no simplex with more vertices are the dangling ones; the
  // others say nothing new. Only claims about a domain look at them.
  std::vector<Simplex> faces = {};

  // The user's own index of a vertex, whether it names a point or not.
  Vertex label(Vertex v) const {
    if (!points.names(v) || labels.empty()) return index_of_place(v, first_index);
    return labels[static_cast<std::size_t>(v)];
  }
};

}  // namespace circumspect
