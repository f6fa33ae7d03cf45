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

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"

namespace circumspect::formats {

// STL repeats a point in every triangle that has it: equal corners become one point, which is
// noted. A triangle with equal corners becomes a segment or a point; that is noted, too. Points are
// counted from 0 in the order in which they first appear. A file is binary if it has a byte 0 or
// does not begin with "solid".
Result<DomainFile> read_stl(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
