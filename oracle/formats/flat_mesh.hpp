// Large meshes of doubles, read into flat arrays: .ele or .npy with points in .node or .npy. What
// mesh_files.hpp would read otherwise, refuse or take from elsewhere has no answer here and is left to
// it; where there is an answer, it is the same mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plain_files.hpp"

namespace circumspect::formats {

struct FlatMesh {
  FlatPoints points = {};
  // m × k, where k is at most the dimension plus 1; vertices are counted from 0, some may name no point.
  std::variant<FlatRows<std::int32_t>, FlatRows<std::int64_t>> simplices = {};
  // If they were asked for: as many as simplices, each with k; counted from 0, −1 for none.
  std::optional<FlatRows<std::int32_t>> neighbors = {};
  Vertex first_neighbor = 0;  // the user's index of the first simplex where neighbours are listed
  // Triangles and edges listed beside the simplices, if they were asked for; counted from 0 as these.
  std::vector<Simplex> faces = {};
  std::string points_name = {};  // of the file with the points, for messages

  std::size_t dimension() const { return points.coordinates.columns(); }
};

// As read_mesh. None for numbers that are taken at their word, for meshes that are held against a
// domain, for pipes that load_streams has not loaded, and for every file that is not of the plain form or
// at fault.
std::optional<FlatMesh> read_flat_mesh(const MeshRequest& request,
                                       const PlainReading& reading = {});

// What read_mesh reads instead, but for markers, line numbers and all attributes after the first.
RawMesh raw_mesh(const FlatMesh& mesh);

}  // namespace circumspect::formats
