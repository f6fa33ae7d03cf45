// Writes triangulations to files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/json.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::cli {

// What is wrong with OUT of `-o OUT`, if only files of some extensions and "-" can be written;
// empty if nothing is. Whatever is there and no file, a pipe say, may have any name, and then gets
// what would go to standard output.
std::string output_name_fault(const std::string& path,
                              const std::vector<std::string_view>& extensions);

// `mesh` has the points, how the user counts them, and the simplices of a triangulation of them:
// positively oriented, so that programs that care find det[p_0 − p_d; …] > 0.

// Vertices by the user's own indices.
formats::SimplexFile simplex_file(const Mesh& mesh);

// All points of the input, each at its own index. Those that were merged (`merged`, by their
// places) have the weight of the point that is left of them; weights are the first attribute.
formats::PointFile point_file(const Mesh& mesh, const std::vector<Duplicate>& merged);

// The file of the points beside `path`, if it has to be written: an .ele alone says nothing, and
// nothing is beside a stream. Empty if it is `input`, where the points come from.
std::string points_beside(const std::string& path, const std::string& input);

// neighbors[s][i]: the simplex across the facet opposite vertex i of simplex s, in the order in
// which simplex_file lists both; −1 on the hull.
formats::NeighborFile neighbor_file(const Mesh& mesh);

// The document lists the points itself, without those that were merged, so that vertices are
// counted among these.
formats::JsonFile json_file(const Mesh& mesh);

}  // namespace circumspect::cli
