// Reads one mesh from files; each rank reads its part.
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
  std::optional<std::string> points = {};  // .npy, or .node; for x.ele the default is x.node
  // If there are parts: the names of a file for each rank (all of them .npy), with %d in the place
  // of its number: which point of the whole each point of the part is, counted from 0.
  std::optional<std::string> indices = {};
  bool weighted = false;  // the first attributes of a .node file count
};

// Thrown if simplices are read again, as ListedRows are, and the file has changed; the message is
// one line.
struct FileChanged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ReadSlices {
  Dealt dealt;
  std::string points_name;  // of the file, for messages
};

// Each rank reads slices of the points and of the simplices, whose lengths differ by at most one
// row between ranks; or its own part, whose simplices follow those of the parts before and name its
// own points. Called by all ranks. Errors, in one line and the same at all ranks: those of the
// readers, in the same words for .npy; a text file that is not of the plain form
// (formats/plain_files.hpp); points of a dimension other than 2 and 3, or simplices that do not
// have one vertex more; missing weights where they count; neither points nor simplices; more
// simplices than a rank can number; a file that has other counts or bytes at another rank; in
// parts, a vertex that is not one of the part's points, a point that has other coordinates in
// another part or is in no part, more parts than ranks.
tl::expected<ReadSlices, std::string> read_slices(Ranks& ranks, const Files& files);

}  // namespace circumspect::distributed
