// What programs write otherwise than the domain that their mesh is of: points of the plane with a
// third coordinate, and dangling triangles and edges as if they were all there is.
#pragma once

#include "oracle/formats/mesh_files.hpp"

namespace circumspect::formats {

// Gmsh and many others write a mesh of the plane as one in space, z = 0. Leaves out the third
// coordinate of points in space if it is exactly the same for all, and notes that; else nothing.
void leave_out_constant_coordinate(MeshFile& file);

// A mesh without simplices of full dimension can only be of what dangles in a domain: takes its
// simplices, if all have as many vertices, 2 at least and fewer than one of full dimension, for the
// faces that they are, and notes that; else nothing. Requires: no neighbours.
void take_for_faces(MeshFile& file);

}  // namespace circumspect::formats
