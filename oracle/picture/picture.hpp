// What is drawn of a witness, as JSON for the page: positions to look at, beside the exact values
// that the report has. A picture decides nothing.
//
// Positions are taken relative to the middle of what the witness names and in units of half its
// size, exactly, and rounded only then: 1e300 and 1e-300 have room in one picture, and neighbours
// one ulp apart stay apart as far as the size of the witness allows.
#pragma once

#include <cstddef>
#include <ostream>
#include <span>
#include <vector>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::picture {

// Pictures of the first violations that the verdict keeps, at most so many, in their order. Of what
// has no picture (points of four dimensions, a witness that names no point) there is {"why_none":
// …}, one sentence. Else:
//   dimension        of the points, 1 to 3; positions always have three numbers
//   points, names    positions, and the user's index of each or ""; the first `core` are the
//                    witness's own
//   simplices        of the witness, lists of points by their place among these; null: an index of
//                    no point
//   face, vertices, point, nearest       likewise, those that there are
//   cell             of the domain: vertex, segment, or polygon with its segments and triangles
//   gap              the corners of the gap where a hull ends (gap.hpp)
//   near, boundary   simplices around the witness; facets of the boundary, of small meshes
//   walls            segments and triangles of the domain in the neighbourhood
//   ball             radius, normal (from the centre towards the first point), surface (where that
//                    line leaves the ball), and the centre unless it is very far
//   caption, mark    of a violation: a sentence that says what is to be seen, and what is drawn
//                    beside these (Mark)
//   thin             a unit normal, and the height of each point along it, each rounded by itself
//   left_out         a sentence, if something near is not drawn
std::vector<report::Json> pictures(const Verdict& verdict, const Mesh& mesh, const Domain* domain,
                                   std::size_t most);
// Likewise of witnesses that no verdict has; `mesh` is what may be drawn around them.
std::vector<report::Json> pictures(std::span<const Witness> witnesses, const Mesh& mesh,
                                   const Domain* domain = nullptr);

// Witnesses as cells, for programs that show meshes: VTK's .vtu, as ParaView reads it, and Gmsh's
// .msh.

enum class CellFormat { kVtu, kGmsh };

// For each violation that the verdict keeps: its simplices, its face, its vertices and its point,
// the centre of its ball, the cell of the domain. Each cell has numbers: `rule`, the rule's own
// number (oracle/model/rules.def; in a .msh a physical group with the rule's name), `violation`,
// counted from 1, and `role`: 0 a simplex, 1 a face, 2 a vertex, 3 the centre of a ball, 4 a cell
// of the domain, 5 a point. Each point has `index`, the user's own or -1, and `radius`, of the ball
// whose centre it is, or 0. Coordinates are the decimals nearest to the exact ones. Requires:
// points of one to three coordinates, or none.
void write_cells(std::ostream& out, CellFormat format, const Verdict& verdict, const Mesh& mesh,
                 const Domain* domain = nullptr);

// What lies around witnesses: the few simplices and facets of a mesh that a picture of one needs
// beside it.

struct Surroundings {
  // Of simplices and listed faces those that share most vertices with the witness, then those whose
  // box holds one of its places; none that is the witness's own. As many as have room.
  std::vector<Simplex> near = {};
  std::size_t left_out = 0;  // how many more there are
};

// Of each witness, in their order. It takes the mesh once from end to end, however many there are.
// Places are compared in doubles: what is near decides nothing.
std::vector<Surroundings> surroundings(std::span<const Witness> witnesses, const Mesh& mesh,
                                       const Domain* domain, std::size_t room);

// The facets that belong to one simplex alone, in order of their vertices within a pass. Simplices
// with indices that name no point, or with more than four vertices, are left out. It passes over
// the mesh as often as keeps the facets that are held at once to about `at_once`. Requires: at_once
// > 0.
std::vector<Simplex> boundary(const Mesh& mesh, std::size_t at_once = 4'000'000);

}  // namespace circumspect::picture
