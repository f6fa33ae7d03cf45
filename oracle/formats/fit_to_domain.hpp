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

// A mesh of more than the domain, as where a program meshes the convex hull and labels what is outside 0:
// keeps the simplices with one of these labels. Faces of the others alone are left out as well, and points
// of these alone; that is noted. Errors: simplices have no labels, or none of them has one of these.
// Requires: as many labels as simplices, or none; no neighbours.
Status keep_labelled(const std::vector<Vertex>& kept, const std::vector<Vertex>& labels,
                     MeshFile& file);

}  // namespace circumspect::formats
