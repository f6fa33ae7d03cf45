// Which cells share a face: facets of simplices, and ridges of hull facets.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle/model/exact_mesh.hpp"

namespace circumspect::certificate {

// One cell's use of a face: a tuple without memory of its own, of which there are millions.
struct FaceUse {
  std::array<std::uint32_t, 3> face;  // its vertices, ascending; what is left over is 0
  std::uint32_t cell;
  std::uint32_t place;  // of the cell's vertex that the face leaves out

  auto operator<=>(const FaceUse&) const = default;
};

// The use of the face opposite vertex number `place`. Requires: at most four vertices.
FaceUse face_use(std::span<const std::uint32_t> vertices, std::size_t cell, std::size_t place);

// The uses of the facets of a mesh. Requires: simplices of at most four vertices, which are points.
std::vector<FaceUse> facets(const ExactMesh& mesh);

void sort(std::vector<FaceUse>& uses);

// Sorts by face, so that the uses of one stand together, and calls `visit` once a face with them.
void for_each_face(std::vector<FaceUse>& uses, const auto& visit) {
  sort(uses);
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first;
    while (last < uses.size() && uses[last].face == uses[first].face) ++last;
    visit(std::span<const FaceUse>(uses).subspan(first, last - first));
    first = last;
  }
}

}  // namespace circumspect::certificate
