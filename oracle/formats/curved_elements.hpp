// Elements of second order and more are judged by their corners: the simplices that they would be
// if they were straight.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// The indices of nodes of curved elements that are not their corners, ascending, each once. They
// are not vertices of the mesh, unless another element has them as a corner.
std::vector<Vertex> nodes_between_corners(const ElementFile& file);

// A note that says how many elements are judged by their corners and, if all are of second order,
// how far the node farthest from the middle of its edge is off. Nothing if no element is curved.
std::optional<std::string> note_of_curved(const ElementFile& file, const std::string& name);

// Leaves only their corners of listed simplices that all have as many nodes as those of second
// order in the dimension of the points, as Triangle and TetGen write them with -o2: 6 in the plane,
// 10 in space, the corners first. Returns the nodes as nodes_between_corners does, and the note;
// nothing, and nothing changes, if the simplices have other numbers of nodes.
struct BetweenCorners {
  std::vector<Vertex> nodes = {};
  std::string note = {};
};
std::optional<BetweenCorners> take_corners(SimplexFile& simplices, const PointFile& points,
                                           const std::string& name);

}  // namespace circumspect::formats
