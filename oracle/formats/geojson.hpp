// GeoJSON (RFC 7946) as a domain: .geojson, or .json with the key "type".
//
//     {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]], [[2, 1], …]]}
//
// Also the coordinates alone, as programs pass them on: those of a ring, a polygon or several.
#pragma once

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"

namespace circumspect::formats {

// Polygons are faces, lines are segments and points are vertices, whatever feature or collection
// they are in. All other keys are skipped, whatever they hold.
Result<DomainFile> read_geojson(const Source& source, NumberReading reading);

// Does a text begin as such a file does? Our own JSON has no key "type".
bool is_geojson(std::string_view text);

}  // namespace circumspect::formats
