// convhull_3d_build: the facets of the hull of points in space, which it takes as floats; the
// points are such.
#include <cstdlib>

#define CONVHULL_3D_ENABLE
#include <convhull_3d.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    std::vector<ch_vertex> vertices;
    for (const auto& p : points) {
      ch_vertex vertex;
      for (int axis = 0; axis < 3; ++axis) vertex.v[axis] = static_cast<CH_FLOAT>(p[axis]);
      vertices.push_back(vertex);
    }
    int* faces = nullptr;
    int count = 0;
    convhull_3d_build(vertices.data(), static_cast<int>(vertices.size()), &faces, &count);
    lines::Simplices made;
    for (int i = 0; i < count; ++i) made.emplace_back(faces + 3 * i, faces + 3 * i + 3);
    std::free(faces);
    return made;
  });
}
