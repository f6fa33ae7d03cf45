// luihabl/delaunator.h, with its own type of numbers, float.
#include <cstddef>

#include <delaunator.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    std::vector<float> coordinates;
    for (const auto& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    const Delaunator d(coordinates);
    lines::Simplices made;
    for (std::size_t i = 0; i + 2 < d.triangles.size(); i += 3) {
      made.push_back({static_cast<long>(d.triangles[i]), static_cast<long>(d.triangles[i + 1]),
                      static_cast<long>(d.triangles[i + 2])});
    }
    return made;
  });
}
