// Meshes as Medit and Gmsh write them, as text: .mesh.
//
//     MeshVersionFormatted 2
//     Dimension 3                                 or 2
//     Vertices 8                                  for each: x y [z] reference
//     Edges 12                                    for each: v0 v1 reference
//     Triangles, Quadrilaterals, Tetrahedra       likewise; indices from 1
//     …                                           other sections are read over
//     End
//
// Numbers follow one another, wherever lines end.
#pragma once

#include <ostream>

#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number_text.hpp"

namespace circumspect::formats {

struct MeditFile {
  PointFile points = {};  // references are dropped; the first index is 1
  SimplexFile edges = {};
  SimplexFile triangles = {};
  SimplexFile quadrilaterals = {};
  SimplexFile tetrahedra = {};
  std::size_t other_cells_line = 0;  // the line of hexahedra, prisms or pyramids; 0: there are none
};

// Is this the keyword with which such a file begins?
bool is_medit_keyword(std::string_view token);

Result<MeditFile> read_medit(const Source& source, NumberReading reading);

// The surface: edges are segments; triangles and quadrilaterals are polygons in space, and in the
// plane, if there are no edges, theirs are taken. Where there are cells, vertices that belong to
// these alone are left out: they are the mesh's, not its domain's.
Result<DomainFile> domain_of(const MeditFile& medit, const std::string& name);

// Requires: points of dimension 2 or 3; vertices are counted from the first index of the points.
void write_medit(std::ostream& out, const MeditFile& file);

}  // namespace circumspect::formats
