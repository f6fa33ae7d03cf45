// From a file to the verdict on the mesh in it: in arrays, if it can be read into these.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/input/input.hpp"
#include "oracle/judge/points/check.hpp"

namespace circumspect::cli {

struct FileVerdict {
  Verdict verdict;
  Mesh mesh;  // all of it, or as much of it as the witnesses name
  std::vector<std::string> notes = {};
};

struct JudgeFileOptions {
  check::Options check;
  InputOptions input;
  bool whole_mesh = false;  // is all of the mesh wanted?
  unsigned threads = 0;     // 0: as many as the machine has
};

// What check::judge says of the mesh, or one line that says what is wrong with the input.
// Requires: not a claim about a domain.
tl::expected<FileVerdict, std::string> judge_file(const std::string& path, Claim claim,
                                                  const JudgeFileOptions& options);

}  // namespace circumspect::cli
