// The types of elements in Gmsh's .msh, by their numbers.
#pragma once

#include <optional>
#include <string_view>

#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// The type of that number if it has the same number of nodes in all versions of Gmsh; else nullptr.
const ElementType* find_gmsh_type(Vertex code);

// What elements of that type are ("a hexahedron of higher order") if they are of higher order, and how many nodes they
// have is not known here: their vertices cannot be read over.
std::optional<std::string_view> gmsh_higher_order(Vertex code);

// Has a version of Gmsh a type of that number?
bool is_known_to_gmsh(Vertex code);

}  // namespace circumspect::formats
