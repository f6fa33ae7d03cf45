// A mesh that a lattice repeats, as a mesh in the plane or in space: with a point for each corner.
#pragma once

#include <string>

#include "oracle/model/mesh.hpp"
#include "oracle/model/periodic.hpp"

namespace circumspect::check {

// Why the mesh and the lattice cannot be judged, one line that says what to do; empty if they can.
std::string fault_of_periodic(const Mesh& listed, const Periodic& periodic);

// The cells by the copies of points that are their corners, with Mesh::copies. It also has the
// copies across each facet of two cells, and those at the ends of the lattice vectors from point
// 0, so that its points span. Labels are those of the listed points. If a cell has an index that
// names no point, all keep their indices, and there are no copies.
// Requires: fault_of_periodic has none.
Mesh unfolded(const Mesh& listed, const Periodic& periodic);

}  // namespace circumspect::check
