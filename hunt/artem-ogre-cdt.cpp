#include <CDT.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    CDT::Triangulation<double> triangulation;
    std::vector<CDT::V2d<double>> vertices;
    for (const auto& p : points) vertices.push_back(CDT::V2d<double>(p[0], p[1]));
    triangulation.insertVertices(vertices);
    triangulation.eraseSuperTriangle();
    lines::Simplices made;
    for (const auto& t : triangulation.triangles)
      made.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
    return made;
  });
}
