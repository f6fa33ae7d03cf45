#include <delaunay.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    std::vector<del_point2d_t> own;
    for (const auto& p : points) own.push_back({p[0], p[1]});
    delaunay2d_t* faces = delaunay2d_from(own.data(), static_cast<unsigned>(own.size()));
    tri_delaunay2d_t* triangles = tri_delaunay2d_from(faces);
    lines::Simplices made;
    for (unsigned i = 0; i < triangles->num_triangles; ++i) {
      made.push_back(
          {triangles->tris[3 * i], triangles->tris[3 * i + 1], triangles->tris[3 * i + 2]});
    }
    tri_delaunay2d_release(triangles);
    delaunay2d_release(faces);
    return made;
  });
}
