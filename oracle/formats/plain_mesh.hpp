// Large meshes of doubles, read where they are to lie: .ele or .npy with points in .node or .npy. What
// mesh_files.hpp would read otherwise, refuse or take from elsewhere has no answer here and is left to
// it; where there is an answer, it is the same mesh.
#pragma once

#include <optional>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plain_files.hpp"

namespace circumspect::formats {

// As read_mesh. None for numbers that are taken at their word, for pipes that load_streams has not loaded,
// and for every file that is not of the plain form or at fault.
std::optional<MeshFile> read_plain_mesh(const MeshRequest& request,
                                        const PlainReading& reading = {});

}  // namespace circumspect::formats
