// Witnesses as cells, for programs that show meshes: VTK's .vtu, as ParaView reads it, and Gmsh's .msh.
#pragma once

#include <ostream>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::picture {

enum class CellFormat { kVtu, kGmsh };

// For each violation that the verdict keeps: its simplices, its face, its vertices and its point, the centre of
// its ball, the cell of the domain. Each cell has numbers: `rule`, the place in the list of rules counted from 1
// (in a .msh a physical group with the rule's name), `violation`, counted from 1, and `role`: 0 a simplex, 1 a
// face, 2 a vertex, 3 the centre of a ball, 4 a cell of the domain, 5 a point. Each point has `index`, the
// user's own or -1, and `radius`, of the ball whose centre it is, or 0. Coordinates are the decimals nearest to
// the exact ones. Requires: points of one to three coordinates, or none.
void write_cells(std::ostream& out, CellFormat format, const Verdict& verdict, const Mesh& mesh,
                 const Domain* domain = nullptr);

}  // namespace circumspect::picture
