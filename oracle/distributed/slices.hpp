// Reads one mesh from files, of which each rank reads its part.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include <tl/expected.hpp>

#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/ranks.hpp"

namespace circumspect::distributed {

struct Files {
  std::string mesh;                        // .npy, or .ele
  std::optional<std::string> points = {};  // .npy, or .node; of x.ele without it: x.node
  // If there are parts, a file for each rank (all of them .npy), in whose names %d stands for its number: which point
  // of the whole each point of the part is, counted from 0.
  std::optional<std::string> indices = {};
  bool weighted = false;  // the first attributes of a .node file count
};

// Thrown where simplices are read once more, as ListedRows are, and the file has become another: in one line.
struct FileChanged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ReadSlices {
  Dealt dealt;
  std::string points_name;  // of the file, for messages
};

// Each rank reads slices of the points and of the simplices, as long as those of the others but for one row; or its
// own part, whose simplices follow those of the parts before and name its own points. Called by all ranks. Errors, in one line and the same at all ranks: those of the readers, for .npy in their words; a text
// file that is not of the plain form (formats/plain_files.hpp); points of a dimension other than 2 and 3, simplices
// that have not one vertex more; no weights where they count; neither points nor simplices; more simplices than a rank
// can number; a file that has another size, header or end at another rank, or other counts; in parts, a vertex that is none of the part's points, a point that has other coordinates in another part
// or is in none, more parts than ranks.
tl::expected<ReadSlices, std::string> read_slices(Ranks& ranks, const Files& files);

}  // namespace circumspect::distributed
