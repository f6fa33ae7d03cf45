// Files that no reader reads, told by what they hold: what they are, and what to do about it. A name may say
// too little (.msh is Gmsh's, Fluent's, FreeFem's, GiD's and JIGSAW's) or something else (an archive, a pointer of Git LFS).
#pragma once

#include <optional>
#include <string>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// For a message "found …": "a file that gzip packed (unpack it first)"; none if nothing is known of it. Looks at the
// beginning alone. Asked only once a reader has refused the file, so no file is refused because of it.
std::optional<std::string> foreign_kind(const Source& source);

// The error of a reader about this file: what was found is the kind of the file, if that is known.
FormatError explained(FormatError error, const Source& source);

template <class T>
Result<T> explained(Result<T> read, const Source& source) {
  if (read || read.error().file != source.name) return read;
  return tl::unexpected(explained(std::move(read.error()), source));
}

}  // namespace circumspect::formats
