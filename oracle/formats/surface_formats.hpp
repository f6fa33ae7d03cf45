// The formats of surfaces: what the files hold, and their readers and writers. PLY's are in
// ply.hpp.
#pragma once

#include <ostream>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/element_file.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

// ---- OFF ----
// Points and faces in Geomview's object file format, as text: .off.
//
//     OFF                      or COFF, NOFF, STOFF…: colours, normals, textures, which are skipped
//     points faces edges       may stand on the line of the keyword; edges may be left out
//     x y z                    one line a point
//     k v0 … v(k-1) colour     one line a face, indices from 0; the colour is skipped; the vertices
//                              may continue on further lines, without a colour after them
//
// `nOFF` puts the dimension on a line of its own (or after the keyword) before the counts.

struct OffFile {
  PointFile points;
  SimplexFile faces;  // of any number of vertices, triangles or not
};

// Is this the keyword with which an OFF file begins?
bool is_off_keyword(std::string_view token);

Result<OffFile> read_off(const Source& source, NumberReading reading);

// Requires: all points have `dimension` coordinates. Attributes and markers are not written.
void write_off(std::ostream& out, const OffFile& file);

// ---- OBJ ----
// Surfaces and lines in Wavefront's format, as text: .obj.
//
//     v x y z                                     further numbers, weights or colours, are skipped
//     f 1 2 3 …                                   or 1/t, 1//n, 1/t/n; −1 is the last point so far
//     l 1 2 …                                     a line of edges end to end
//     vt, vn, g, o, s, usemtl, mtllib, …          read over
//
// A backslash at the end of a line joins it with the next one.

// Does a file with this first word look like one?
bool is_obj_keyword(std::string_view token);

// Points are counted from 1.
Result<ElementFile> read_obj(const Source& source, NumberReading reading);

// The points, the surface (surface_of) and the edges. Requires: as write_gmsh.
void write_obj(std::ostream& out, const ElementFile& file);

// ---- STL ----
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

// STL repeats a point in every triangle that has it: equal corners become one point, which is
// noted. A triangle with equal corners becomes a segment or a point; that is noted, too. Points are
// counted from 0 in the order in which they first appear. A file is binary if it has a byte 0 or
// does not begin with "solid".
Result<DomainFile> read_stl(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
