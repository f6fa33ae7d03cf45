// Cells as in all formats of VTK, in its legacy files and in XML: lists of vertices and a type of
// each.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Cells without a type have the type of the surface's list that contains them.
struct VtkCells {
  SimplexRows vertices = {};
  Runs<std::size_t> lines = {};
};

// Types of cells that lists of a surface have.
inline constexpr Vertex kVtkVertices = 2;
inline constexpr Vertex kVtkPolyline = 4;
inline constexpr Vertex kVtkStrip = 6;
inline constexpr Vertex kVtkPolygon = 7;

// Adds a cell. If its type or its number of vertices is wrong, returns what was expected.
std::optional<std::string> add_vtk_cell(ElementFile& file, Vertex type,
                                        std::span<const Vertex> vertices, std::size_t line,
                                        std::optional<Vertex> label = {});

// Takes all cells over at once, if the file has none so far and all of them are tetrahedra,
// triangles or edges; else does nothing and returns false.
bool take_vtk_cells(ElementFile& file, const Indices& types, VtkCells& cells);

// Takes cells out of one list of all their vertices: cell i ends before place offsets[i]. Errors,
// as those of `text`: offsets that go down or beyond the list.
Result<VtkCells> cells_of(const MixedText& text, const Indices& offsets, Indices connectivity,
                          std::size_t line);

}  // namespace circumspect::formats
