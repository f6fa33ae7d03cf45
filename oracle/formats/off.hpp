// Points and faces in Geomview's object file format, as text: .off.
//
//     OFF                      or COFF, NOFF, STOFF…: colours, normals, textures, which are skipped
//     points faces edges       may stand on the line of the keyword; edges may be left out
//     x y z                    one line a point
//     k v0 … v(k-1) colour     one line a face, indices from 0; the colour is skipped; the vertices
//                              may continue on further lines, without a colour after them
//
// `nOFF` puts the dimension on a line of its own (or after the keyword) before the counts.
#pragma once

#include <ostream>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

struct OffFile {
  PointFile points;
  SimplexFile faces;  // of any number of vertices, triangles or not
};

// Is this the keyword with which an OFF file begins?
bool is_off_keyword(std::string_view token);

Result<OffFile> read_off(const Source& source, NumberReading reading);

// Requires: all points have `dimension` coordinates. Attributes and markers are not written.
void write_off(std::ostream& out, const OffFile& file);

}  // namespace circumspect::formats
