// The domain among the elements of a mesh.
#pragma once

#include <string>

#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// The surface as a domain: edges are segments; triangles and polygons are polygons in space, and in
// the plane their edges are segments if no edges are listed. Vertices that belong only to cells are
// left out: they belong to the mesh, not to its domain. Errors: curved elements; nothing but cells.
Result<DomainFile> domain_of(const ElementFile& elements, const std::string& name);

// The same, taken for planar if it is (plane.hpp). Where edges are listed, they are then the
// domain, and triangles are cells of its mesh.
Result<DomainFile> plane_or_space_of(const ElementFile& elements, const std::string& name);

}  // namespace circumspect::formats
