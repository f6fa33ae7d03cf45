#include <CDT.h>

#include "lines.hpp"

int main() {
  return lines::serve_domains([](const lines::Points& points, const lines::Segments& segments) {
    CDT::Triangulation<double> triangulation;
    std::vector<CDT::V2d<double>> vertices;
    for (const auto& p : points) vertices.push_back(CDT::V2d<double>(p[0], p[1]));
    CDT::EdgeVec edges;
    for (const auto& [a, b] : segments)
      edges.push_back(CDT::Edge(CDT::VertInd(a), CDT::VertInd(b)));
    triangulation.insertVertices(vertices);
    triangulation.insertEdges(edges);
    triangulation.eraseSuperTriangle();
    lines::Simplices made;
    for (const auto& t : triangulation.triangles)
      made.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
    return made;
  });
}
