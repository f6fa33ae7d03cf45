// The text of a file, and the name under which messages speak of it.
#pragma once

#include <string>

#include "oracle/formats/format_error.hpp"

namespace circumspect::formats {

struct Source {
  std::string name;
  std::string text;
};

// Reads a whole file, or a pipe; "-" is standard input, named "<stdin>". A directory, a device, a
// file that is not there or may not be read is an error that says so.
Result<Source> load(const std::string& path);

// Does a file, of whatever kind, stand at this path?
bool exists(const std::string& path);

// Is it one whose bytes stay where they are: no pipe, device or folder?
bool is_regular(const std::string& path);

}  // namespace circumspect::formats
