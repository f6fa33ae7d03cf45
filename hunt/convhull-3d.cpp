// delaunay_nd_mesh, which takes floats; the points are such.
#include <cstdlib>

#define CONVHULL_3D_ENABLE
#include <convhull_3d.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    const int dimension = static_cast<int>(points[0].size());
    std::vector<float> coordinates;
    for (const auto& p : points)
      for (const double x : p) coordinates.push_back(static_cast<float>(x));
    int* simplices = nullptr;
    int count = 0;
    delaunay_nd_mesh(coordinates.data(), static_cast<int>(points.size()), dimension, &simplices,
                     &count);
    lines::Simplices made;
    for (int i = 0; i < count; ++i) {
      const int* first = simplices + i * (dimension + 1);
      made.emplace_back(first, first + dimension + 1);
    }
    std::free(simplices);
    return made;
  });
}
