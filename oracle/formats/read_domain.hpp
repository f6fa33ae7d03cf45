// Finds and reads domains, whatever their format: a piecewise linear complex in one file, or in
// two, as users of Triangle and TetGen keep it.
#pragma once

#include <string>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"

namespace circumspect::formats {

// A file of any format that holds a domain (the points of .poly and .smesh in it or in the .node
// beside it); one with another name is recognised by its content. "-" is standard input.
Result<DomainFile> read_domain(const std::string& path, NumberReading reading);

// Does the name of this file say that it is a domain? (.off may also be a list of points, and so
// may a .ply without faces; the latter is read to find out.)
bool is_domain_file(const std::string& path);

}  // namespace circumspect::formats
