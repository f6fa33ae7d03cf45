// How a mesh is connected, and how large it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oracle/model/mesh.hpp"

namespace circumspect::quality {

struct Topology {
  std::vector<std::size_t> faces =
      {};  // how many of each dimension, from 0 to that of the simplices
  std::int64_t euler_characteristic = 0;  // their alternating sum
  std::size_t boundary_facets = 0;        // that one simplex has
  std::size_t boundary_parts = 0;         // that ridges connect
  // Of the surface, or of the boundary of tetrahedra, all parts together: how many handles. None if
  // a ridge of it is in more than two facets, if it has no orientation, or of edges. It is what the
  // word says if the mesh is a manifold.
  std::optional<std::size_t> genus = {};
};

// Of the simplices that are not set apart (exact_measure.hpp).
Topology topology(const Mesh& mesh);

// The sum of the sizes of all simplices that are not set apart: volume, area or length.
struct Size {
  std::optional<Rational> exact = {};  // if the simplices have the dimension of the space
  std::string decimal;                 // correctly rounded
};
Size size_of(const Mesh& mesh);

// The same of the facets that one simplex has. Requires: the mesh has simplices of dimension 2 or
// 3.
Size size_of_boundary(const Mesh& mesh);

}  // namespace circumspect::quality
