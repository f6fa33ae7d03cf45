// Recognises files that no reader reads by their content: what they are, and what to do about it. A
// name may say too little (.msh is Gmsh's, Fluent's, FreeFem's, GiD's and JIGSAW's) or something
// else (an archive, a pointer of Git LFS).
#pragma once

#include <optional>
#include <string>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// For a message "found …": "a file that bzip2 packed (unpack it first)"; nothing if the kind is
// unknown. It looks only at the beginning, and is asked only once a reader has refused the file, so
// it never causes a refusal.
std::optional<std::string> foreign_kind(const Source& source);

// The error of a reader about this file; as what was found, it names the kind of the file if that
// is known.
FormatError explained(FormatError error, const Source& source);

template <class T>
Result<T> explained(Result<T> read, const Source& source) {
  if (read || read.error().file != source.name) return read;
  return tl::unexpected(explained(std::move(read.error()), source));
}

}  // namespace circumspect::formats
