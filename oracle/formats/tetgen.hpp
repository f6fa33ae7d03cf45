// The files of Triangle and TetGen: points, simplices, faces and neighbours, each a numbered
// list.
#pragma once

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/numbered_lines.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

// Points as Triangle and TetGen write them: .node.
//
//     points dimension [attributes [markers]]       markers: 0 or 1
//     index x y … attributes… [marker]              one line a point

// What the header says. The number of rows is that of the list.
struct NodeHeader {
  std::size_t dimension = 0;
  std::size_t attributes = 0;
  std::size_t markers = 0;

  std::size_t columns() const { return 1 + dimension + attributes + markers; }
};
// `may_be_empty`: without points, nothing else is required.
Result<NodeHeader> read_node_header(NumberedLines& numbered, bool may_be_empty);

// Points of dimension 1 to kLargestDimension. The first index may be any integer, the others
// follow one by one; a marker is an integer.
Result<PointFile> read_node(const Source& source, NumberReading reading);

// The list with which .poly and .smesh begin. If it has no points, they are in a .node file, and
// the dimension may be left out: 0.
Result<PointFile> read_node_list(NumberedLines& numbered, NumberReading reading);

// Coordinates and attributes are written so that reading them as doubles gives the same numbers.
// Requires: all points have `dimension` coordinates; attributes and markers are empty or one a
// point, all rows of attributes have one length.
void write_node(std::ostream& out, const PointFile& file);

// Triangles and tetrahedra as Triangle and TetGen write them: .ele.
//
//     simplices k [attributes]                      k: vertices of each
//     index v0 … v(k-1) attributes…                 one line a simplex

struct EleHeader {
  std::size_t vertices = 0;
  std::size_t attributes = 0;

  std::size_t columns() const { return 1 + vertices + attributes; }
};
Result<EleHeader> read_ele_header(NumberedLines& numbered);

// The k vertices of each simplex, as written. An .ele file does not say the dimension, so that
// elements of second order (6 nodes in the plane, 10 in space) are returned with all their nodes.
// Attributes have to be numbers and are otherwise ignored. Indices of simplices are consecutive.
Result<SimplexFile> read_ele(const Source& source, NumberReading reading = NumberReading::kDouble);

// The attributes of each simplex as integers, `dimension` for each vertex: how a lattice moves it
// (oracle/model/periodic.hpp). Errors: other attributes.
Result<std::vector<Simplex>> read_ele_offsets(const Source& source, std::size_t dimension);

// Requires: every simplex has vertices_per_simplex vertices, at least 1.
void write_ele(std::ostream& out, const SimplexFile& file);

// Triangles and edges as Triangle and TetGen write them beside a mesh: .face and .edge.
//
//     faces [markers]                             markers: 0 or 1
//     index v0 v1 v2 [marker] …                   .edge: two vertices
//
// TetGen may append the tetrahedra beside each.

// The `vertices` vertices of each, 3 or 2, as written; the markers are the labels. TetGen's
// additions must be integers, the same number on every line, and are otherwise ignored.
Result<SimplexFile> read_face(const Source& source, std::size_t vertices);

// Adds the markers of triangles to others, by their vertices counted from 0, ascending; but not 0.
void add_markers(const SimplexFile& file, Vertex first_index, std::map<Simplex, Vertex>& markers);

// Writes no markers. Requires: all simplices have the same number of vertices.
void write_face(std::ostream& out, const SimplexFile& file);

// Which simplices are neighbours, as Triangle and TetGen write it: .neigh.
//
//     simplices k                                   k: neighbours of each
//     index n0 … n(k-1)                             one line a simplex
//
// Neighbour i shares the facet opposite vertex i of the .ele file; -1: there is none.
struct NeighborFile {
  std::vector<std::vector<Vertex>> neighbors = {};  // indices of simplices exactly as in the file
  std::size_t neighbors_per_simplex = 0;
  Vertex first_index = 0;  // the user's index of the first simplex

  friend bool operator==(const NeighborFile&, const NeighborFile&) = default;
};

// The number of neighbours of each.
Result<std::size_t> read_neigh_header(NumberedLines& numbered);

// The simplices whose neighbours a file should list.
struct ListedSimplices {
  std::size_t count = 0;
  std::size_t vertices = 0;  // of each
  std::string name = {};     // of their file, for messages
};

// Errors, besides those of the format: if `simplices` is given, the file has neighbours for more or
// fewer simplices, or more or fewer for each, than `simplices` says.
Result<NeighborFile> read_neigh(const Source& source,
                                const std::optional<ListedSimplices>& simplices = {});

// Requires: every simplex has neighbors_per_simplex neighbours, at least 1.
void write_neigh(std::ostream& out, const NeighborFile& file);

}  // namespace circumspect::formats
