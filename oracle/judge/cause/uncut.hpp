// Faces that one side of a mesh is cut at, and the other is not, although the vertex is only near.
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number.hpp"
#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// A vertex beside the middle parts of a face, such as the rounded middle of an edge.
struct Uncut {
  Vertex vertex = 0;
  Simplex face = {};  // ascending, of two vertices or three
  Rational squared_distance = 0;
};

// Only where the simplices with the face, cut at the vertex, have the facets of those across. None
// if there are too many bare facets. Requires: they are those of the mesh.
std::vector<Uncut> uncut_faces(const Mesh& mesh, const std::vector<BareFacet>& bare);

}  // namespace circumspect::check
