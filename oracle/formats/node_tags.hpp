// Files that give each node a tag of its own, in any order, by which elements name it: those of
// Gmsh, Abaqus and Nastran.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Puts the points into the order of their tags, which become indices: unchanged, or counted from 1
// if they have gaps, which is noted. `tags`: one a point, in their order in the file; `where`: what
// lists them, for messages ("in $Nodes"). Errors: a tag that is there twice; if there are gaps, an
// element with a tag that no node has.
Status index_by_tags(ElementFile& file, std::vector<Vertex> tags, const std::string& name,
                     std::string_view where);

}  // namespace circumspect::formats
