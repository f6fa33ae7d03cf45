// What a user hands in: points and a list of simplices that some program made of them.
#pragma once

#include <optional>
#include <vector>

#include "reference/complex/point_set.hpp"
#include "reference/complex/simplex.hpp"

namespace circumspect {

// Simplices name points by their index from 0; an index that names no point stays in place, for the
// checker to report. `labels` translates back: the user's own index of each point.
struct Mesh {
  PointSet points;
  std::vector<Simplex> simplices;
  std::vector<Vertex> labels = {};  // empty: the index itself
  Vertex first_index = 0;           // the user's index of the first point, and of the first simplex
  // If the user lists neighbours: for vertex i of a simplex the index, from 0, of the simplex across
  // the opposite facet; negative for none. One row a simplex, one entry a vertex.
  std::optional<std::vector<std::vector<Vertex>>> neighbors = {};

  // The user's own index of a vertex, whether it names a point or not.
  Vertex label(Vertex v) const {
    if (!points.names(v) || labels.empty()) return v + first_index;
    return labels[static_cast<std::size_t>(v)];
  }
};

}  // namespace circumspect
