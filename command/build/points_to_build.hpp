// Points for what `build` makes that is not a mesh.
#pragma once

#include <optional>
#include <string>

#include "command/input/input.hpp"
#include "command/output/output.hpp"

namespace circumspect::cli {

// Reads them. That equal points were merged is the last of their notes. The caller prints these:
// where its text is a file that other programs read, they have no place in it. Nothing if the
// points cannot be read, which is then an error of the output.
std::optional<LoadedPoints> points_to_build(const std::string& path, const InputOptions& input,
                                            Output& output);

}  // namespace circumspect::cli
