// What keeps an input from being a piecewise linear complex, in words.
#pragma once

#include <string>

#include "oracle/formats/domain_file.hpp"
#include "oracle/report/json.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"

namespace circumspect::cli {

// "3 (line 17)", or "3" where the file has no lines.
std::string polygon_name(std::size_t polygon, const formats::DomainFile& file);

// "x.poly:17": the file, and the line of what is named first.
std::string breach_place(const Breach& breach, const formats::DomainFile& file);

// "plc.polygon-not-planar: vertex 4 at (0, 1, 0.125) is 0.125 off the plane of 1 2 3 along z, …"
std::string breach_line(const Breach& breach, const formats::DomainFile& file);

// {"rule", "meaning", …}: what the breach has, vertices by the user's indices, exact values.
report::Json breach_json(const Breach& breach, const formats::DomainFile& file);

// "(0, 1/3, 0.125)": a double stands as its shortest decimal, a long fraction as "~ 0.3333333333333333".
std::string point_text(const Point& point);

}  // namespace circumspect::cli
