// The points of which something is built that is not a mesh.
#pragma once

#include <optional>
#include <string>

#include "command/input/input.hpp"
#include "command/output/output.hpp"

namespace circumspect::cli {

// Reads them, and says what may have been meant otherwise. Nothing if they cannot be read, which is
// then an error of the output. That equal points were merged is left to the caller to say: where
// the text is a file that other programs read, there is no place for it.
std::optional<LoadedPoints> points_to_build(const std::string& path, const InputOptions& input,
                                            Output& output);

}  // namespace circumspect::cli
