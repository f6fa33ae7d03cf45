// Large meshes of doubles, read into flat arrays: .ele or .npy with points in .node or .npy. What
// mesh_files.hpp would read otherwise, refuse or take from elsewhere has no answer here and is left to
// it; where there is an answer, it is the same mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plain_files.hpp"

namespace circumspect::formats {

struct FlatMesh {
  FlatPoints points = {};
  // m × k, where k is at most the dimension plus 1; vertices are counted from 0, some may name no point.
  std::variant<FlatRows<std::int32_t>, FlatRows<std::int64_t>> simplices = {};
  // If they were asked for: as many as simplices, each with k; counted from 0, −1 for none.
  std::optional<FlatRows<std::int32_t>> neighbors = {};

  std::size_t dimension() const { return points.coordinates.columns(); }
};

// As read_mesh. None for numbers that are taken at their word, for meshes that are held against a
// domain, for what comes through a pipe, and for every file that is not of the plain form or at fault.
std::optional<FlatMesh> read_flat_mesh(const MeshRequest& request,
                                       const PlainReading& reading = {});

}  // namespace circumspect::formats
