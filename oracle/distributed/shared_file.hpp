// Do all ranks see the same file under the given name?
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "oracle/distributed/ranks.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::distributed {

// What a rank has read about the whole file.
struct Counted {
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  Vertex first_index = 0;

  bool operator==(const Counted&) const = default;
};

// A name may refer to different files on different machines, or in different folders. Slices of two
// files do not form a mesh, and ranks with different numbers of points would wait for each other
// for ever. Called by all ranks when each has read its part. Ranks of one machine that see one and
// the same file need nothing else; if there are several copies, the ranks that see a copy digest
// all of its bytes, each an equal part. Errors, the same at all ranks: the ranks' files differ in
// their counts, their size or any byte (two copies with equal digests of 64 bits by chance
// excepted). This finds mistakes, and is not a defence against an attack.
formats::Status check_shared(Ranks& ranks, const std::string& path, const Counted& own);

}  // namespace circumspect::distributed
