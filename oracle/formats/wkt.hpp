// Well-known text (OGC 06-103r4) as a domain: .wkt.
//
//     MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0), (2 1, 3 1, 3 2, 2 1)), ((5 0, 6 0, 6 1, 5 0)))
#pragma once

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"

namespace circumspect::formats {

// One geometry or several, with commas, semicolons or nothing between them. Polygons, triangles and
// the faces of surfaces are faces; lines are segments and points are vertices. A third coordinate
// is taken, a measure (M) is left out. EWKT's number of a reference system is skipped.
Result<DomainFile> read_wkt(const Source& source, NumberReading reading);

// Does a text begin with the name of a geometry?
bool is_wkt(std::string_view text);

}  // namespace circumspect::formats
