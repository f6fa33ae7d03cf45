// Meshes and surfaces in VTK's legacy format, and cells as in all formats of VTK.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "kernel/exact/number.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// ---- VTK cells ----
// Cells of VTK, in its legacy files and in XML: lists of vertices and a type of each.

// Cells without a type have the type of the surface's list that contains them.
struct VtkCells {
  std::vector<Simplex> vertices = {};
  std::vector<std::size_t> lines = {};
};

// Types of cells that lists of a surface have.
inline constexpr Vertex kVtkVertices = 2;
inline constexpr Vertex kVtkPolyline = 4;
inline constexpr Vertex kVtkStrip = 6;
inline constexpr Vertex kVtkPolygon = 7;

// Adds a cell. If its type or its number of vertices is wrong, returns what was expected.
std::optional<std::string> add_vtk_cell(ElementFile& file, Vertex type, Simplex vertices,
                                        std::size_t line);

// Takes cells out of one list of all their vertices: cell i ends before place offsets[i]. Errors,
// as those of `text`: offsets that go down or beyond the list.
Result<VtkCells> cells_of(const MixedText& text, const std::vector<Vertex>& offsets,
                          const std::vector<Vertex>& connectivity, std::size_t line);

// Reads so many points of three coordinates.
Status read_vtk_points(MixedText& text, NumberType type, std::size_t count,
                       std::vector<Point>& points);

// Reads so many integers.
Result<std::vector<Vertex>> read_vtk_integers(MixedText& text, NumberType type, std::size_t count,
                                              const std::string& what);

// ---- VTK ----
// Meshes and surfaces in VTK's legacy format, in text or binary: .vtk.
//
//     # vtk DataFile Version 3.0                  5.1: cells as offsets and vertices, else as rows
//     a title
//     ASCII                                       or BINARY, whose byte order is big-endian
//     DATASET UNSTRUCTURED_GRID                   or POLYDATA
//     POINTS 8 double                             three coordinates each
//     CELLS 12 60, CELL_TYPES 12                  or VERTICES, LINES, POLYGONS, TRIANGLE_STRIPS
//     CELL_DATA, POINT_DATA …                     and what follows: not looked at
//
// Numbers in text are taken as they are written, whatever type is declared.

// Does the text begin as such a file does?
bool is_vtk(std::string_view text);

// Points are counted from 0.
Result<ElementFile> read_vtk(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
