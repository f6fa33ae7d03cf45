// Do all ranks see one file under the name that they were given?
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "oracle/distributed/ranks.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::distributed {

// What a rank has read of the whole file.
struct Counted {
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  Vertex first_index = 0;

  bool operator==(const Counted&) const = default;
};

// A name may lead to another file on another machine, or in another folder. Slices of two files are no mesh, and ranks
// that count other points wait for each other for ever. Called by all ranks, of which each has read its
// part. Errors, the same at all ranks: a file has other counts, another size, or other bytes at its beginning, where its
// header is, or its end. This finds mistakes, and does not defend against anybody.
formats::Status check_shared(Ranks& ranks, const std::string& path, const Counted& own);

}  // namespace circumspect::distributed
