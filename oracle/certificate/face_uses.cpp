#include "oracle/certificate/face_uses.hpp"

#include <algorithm>

namespace circumspect::certificate {

FaceUse face_use(std::span<const std::uint32_t> vertices, std::size_t cell, std::size_t place) {
  FaceUse use{{0, 0, 0}, static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(place)};
  std::size_t size = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i == place) continue;
    std::size_t at = size++;
    for (; at > 0 && use.face[at - 1] > vertices[i]; --at) use.face[at] = use.face[at - 1];
    use.face[at] = vertices[i];
  }
  return use;
}

std::vector<FaceUse> facets(const ExactMesh& mesh) {
  std::vector<FaceUse> uses;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const std::vector<std::uint32_t> vertices(mesh.simplices[s].begin(), mesh.simplices[s].end());
    for (std::size_t place = 0; place < vertices.size(); ++place) {
      uses.push_back(face_use(vertices, s, place));
    }
  }
  return uses;
}

void sort(std::vector<FaceUse>& uses) { std::sort(uses.begin(), uses.end()); }

}  // namespace circumspect::certificate
