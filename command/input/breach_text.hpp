// Says in words, and for pictures, why an input is not a piecewise linear complex.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::cli {

// "3 (line 17)", or "3" where the file has no lines.
std::string polygon_name(std::size_t polygon, const formats::DomainFile& file);

// "x.poly:17": the file, and the line of what is named first.
std::string breach_place(const Breach& breach, const formats::DomainFile& file);

// "plc.polygon-not-planar: …: polygon 2 (line 13), vertices 4 5 6 7, ~ 0.03 off the plane that is
// nearest …"
std::string breach_line(const Breach& breach, const formats::DomainFile& file);

// {"rule", "meaning", …}: what the breach has, vertices by the user's indices, exact values.
report::Json breach_json(const Breach& breach, const formats::DomainFile& file);

// What a card of a page (picture::Facts) shows of it: the polygons, the segments and the vertices
// in question, by the points of the file.
std::pair<report::Json, Witness> breach_card(const Breach& breach, const formats::DomainFile& file);

// The whole domain, if it has few edges.
std::optional<std::pair<report::Json, Witness>> domain_card(const formats::DomainFile& file);

// The points of the file, and its segments and the edges of its polygons: what may be drawn around
// a breach.
Mesh skeleton(const formats::DomainFile& file);

}  // namespace circumspect::cli
