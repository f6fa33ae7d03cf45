// `inspect --simplex`: is one simplex Delaunay, or strongly Delaunay? Book: Section 4.2.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/input/input.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::cli {

struct SimplexAnswer {
  std::string text;  // one line
  report::Json json;
};

// `vertices` are the user's own indices, separated by blanks or commas. Returns the answer with a
// ball that shows it or the points that forbid it; or one line that says what is wrong with the
// question: an index that names no point, a vertex twice, vertices that are affinely dependent.
// `repeated`: the points that were merged into equal ones, by places in the file; they name these.
tl::expected<SimplexAnswer, std::string> inspect_simplex(const ExactMesh& mesh,
                                                         const std::vector<Duplicate>& repeated,
                                                         const std::string& vertices);

}  // namespace circumspect::cli
