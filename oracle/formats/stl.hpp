// Surfaces of triangles as STL, in text or binary.
//
//     solid [name]                           80 bytes of anything
//     facet normal nx ny nz                  the number of triangles, 32 bits
//     outer loop                             for each: 12 floats of 32 bits, the normal first,
//     vertex x y z                             then 16 bits of anything; all little-endian
//     vertex x y z
//     vertex x y z
//     endloop
//     endfacet
//     endsolid [name]                        several solids may follow one another
//
// Words may be in any case. Normals are ignored, whatever they are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Is this binary, of the size that its number of triangles tells? Its header tells nothing.
bool is_binary_stl(std::string_view text);

// STL repeats a point in every triangle that has it, and has no indices. Corners whose coordinates
// are the same numbers become one point, which is noted; nothing that merely lies close is merged.
// Points are counted from 0 in the order in which they first appear.
struct StlFile {
  std::string name;
  std::vector<Point> points = {};
  std::vector<Simplex> triangles = {};  // those with equal corners, too
  std::vector<std::size_t> lines = {};  // of each; 0: a binary file
  std::vector<std::string> notes = {};
};

// A file is binary if it has a byte 0 or does not begin with "solid".
Result<StlFile> read_stl_file(const Source& source, NumberReading reading);

// As a domain: a triangle with equal corners becomes a segment or a point, which is noted.
Result<DomainFile> read_stl(const Source& source, NumberReading reading);

// As a mesh: every triangle is listed as it stands, for the judge to name one with equal corners.
Result<ElementFile> read_stl_elements(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
