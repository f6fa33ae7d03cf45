// A format of files is one row of a table: its endings, how its content tells it, what reads it and
// what writes it. Every list of formats, in messages and in the help, is made of these rows.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/element_file.hpp"
#include "oracle/formats/included_files.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/weights.hpp"

namespace circumspect::formats {

// The content of one file of a mesh.
struct Contents {
  SimplexFile simplices = {};
  std::optional<RawPoints> points = {};
  std::vector<Simplex> faces = {};  // listed beside the simplices
  // Indices of points that are in no simplex and no face, but in an element of higher order between
  // its corners, ascending; some may be corners of others.
  std::vector<Vertex> nodes_between = {};
  std::vector<std::string> notes = {};
};

struct Format {
  // In small letters, the usual one first: ".tet", ".tetrahedra".
  std::array<std::string_view, 2> endings;
  // Does a file begin as one of this format does? Null if that cannot be told.
  bool (*is_told)(const Beginning&) = nullptr;
  // The same for lists of numbers, which say so little that all other formats are asked before.
  bool (*is_taken_for)(const Beginning&) = nullptr;
  // If an earlier row has the same ending: does the file begin as one of this format does?
  bool (*is_meant)(const Beginning&) = nullptr;

  // Readers; null if such a file has no such content.
  Result<RawPoints> (*points)(const Source&, NumberReading) = nullptr;
  Result<Contents> (*mesh)(const Source&, NumberReading) = nullptr;
  Result<DomainFile> (*domain)(const Source&, NumberReading) = nullptr;
  // Elements of all dimensions: points, a mesh, and unless it is said that all are cells, a domain.
  Result<ElementFile> (*elements)(const Source&, NumberReading) = nullptr;
  // Finds the files that such a file includes; null if it includes none.
  InclusionAt includes = nullptr;
  bool are_cells = false;
  bool is_surface = false;  // triangles in space alone, which fill nothing

  // Writes a mesh with its points in one file; null if nothing does. Requires: points of dimension
  // 2 or 3, whose third coordinate is written as 0; vertices are counted from the first index of
  // the points.
  void (*write)(std::ostream&, const ElementFile&) = nullptr;

  std::string_view points_beside = {};     // the ending of the file with the points of this mesh
  std::string_view simplices_beside = {};  // the ending of the file with simplices of these points
  std::string_view aside = {};             // for the help: "with --points"

  bool has_points() const { return points != nullptr || elements != nullptr; }
  bool has_mesh() const { return mesh != nullptr || elements != nullptr; }
  bool has_domain() const { return domain != nullptr || (elements != nullptr && !are_cells); }

  // Read it. Requires: it has such content. Planar domains are taken for such (plane.hpp).
  Result<RawPoints> read_points(const Source& source, NumberReading reading) const;
  Result<Contents> read_mesh(const Source& source, NumberReading reading) const;
  Result<DomainFile> read_domain(const Source& source, NumberReading reading) const;
};

// All rows.
std::span<const Format> formats();

// The format whose files have this ending; null if there is none.
const Format* format_of(std::string_view ending);
// The same for a file: where formats share an ending, the content decides.
const Format* format_of(std::string_view ending, const Source& source);

// What a format has of what is looked for.
using Has = bool (Format::*)() const;

// The format of a file whose name does not tell, among those with such content; null if it cannot
// be known. `has_points`: the user says which points the mesh is about.
const Format* told_format(const Source& source, Has content, bool has_points = false);

// The endings of all formats with such content: ".node, .json". The help also says which files go
// together: ".ele (points in the .node beside it)".
std::string endings_of(Has content);
std::string endings_in_help(Has content);

// What writes files of this ending; null if nothing does.
using ElementWriter = void (*)(std::ostream&, const ElementFile&);
ElementWriter writer_of(std::string_view ending);

// The endings of formats that are written: {".mesh", ".msh"}.
std::vector<std::string_view> written_endings();

}  // namespace circumspect::formats
