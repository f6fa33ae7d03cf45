// Surfaces and clouds of points as PLY, in text or binary of either byte order.
//
//     ply
//     format ascii 1.0                            or binary_little_endian, binary_big_endian
//     comment …                                   and obj_info …: ignored
//     element vertex 8
//     property float x                            y and z too, of any type, among other properties
//     element face 6
//     property list uchar int vertex_indices      or vertex_index
//     end_header
//     …                                           the elements, one list of each kind
//
// Elements and properties of other names are skipped. Lines may also end with a carriage return
// alone, as programs for old Macintoshes write them.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

struct PlyFile {
  PointFile points;        // counted from 0
  SimplexFile faces = {};  // of any number of vertices; none in a cloud of points
};

// The points, and the faces if there are any.
Result<PlyFile> read_ply_file(const Source& source, NumberReading reading);

// The same as elements, faces as polygons.
Result<ElementFile> read_ply_elements(const Source& source, NumberReading reading);

// Writes text: the points, the surface (surface_of) and the edges, if there are any. Requires: as
// write_gmsh.
void write_ply(std::ostream& out, const ElementFile& file);

// A surface. Faces are polygons of one line. A file without the element `face` is an error, too.
Result<DomainFile> read_ply(const Source& source, NumberReading reading);

// The header of a PLY file: the elements, their numbers and their properties.

// char, uchar, short, ushort, int, uint, float and double, or int8 … float64.
struct PlyType {
  enum class Kind { kSigned, kUnsigned, kFloating } kind = Kind::kSigned;
  std::size_t size = 0;  // in bytes
};

struct PlyProperty {
  std::string name;
  PlyType type;                       // of the value, or of each value of a list
  std::optional<PlyType> count = {};  // a list: of the number of its values, an integer
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties = {};
  // The place of a property of that name, list or not.
  std::optional<std::size_t> find(std::string_view property, bool is_list) const;
};

struct PlyHeader {
  std::optional<ByteOrder> binary = {};  // none: text
  std::vector<PlyElement> elements = {};
};

// Reads the header, so that the next line is the first one after it. Errors include elements
// without properties, because the file could not confirm their number.
Result<PlyHeader> read_ply_header(Lines& lines);

}  // namespace circumspect::formats
