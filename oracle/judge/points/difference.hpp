// Are two meshes the same complex, up to the numbering of points and the order of everything?
#pragma once

#include <vector>

#include "oracle/judge/points/cells.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

// What one mesh has and the other has not, by indices from 0 into that mesh. Points are matched by
// exact coordinates and, where either mesh has weights, by weight; simplices as sets of matched
// vertices, each as often as it is listed. A simplex with a vertex that names no point, or one that
// the other mesh lacks, matches nothing.
struct Difference {
  std::vector<Vertex> points_only_in_a = {};
  std::vector<Vertex> points_only_in_b = {};
  std::vector<Simplex> simplices_only_in_a = {};  // as that mesh lists them, in its order
  std::vector<Simplex> simplices_only_in_b = {};

  bool empty() const {
    return points_only_in_a.empty() && points_only_in_b.empty() && simplices_only_in_a.empty() &&
           simplices_only_in_b.empty();
  }
};

// The cells that are compared: the simplices, and the faces beside them that dangle.
Cells cells_of(const ExactMesh& mesh);

// Compares the simplices, and of the faces that a mesh lists beside them those that dangle: the others
// say nothing new.
Difference difference(const ExactMesh& a, const ExactMesh& b);

}  // namespace circumspect::check
