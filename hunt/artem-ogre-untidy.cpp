// Segments that touch, cross and overlap, points that are there twice: as its README tells to hand
// over such input.
#include <cstdio>

#include <CDT.h>

int main() {
  long n = 0, m = 0, f = 0, h = 0;
  while (std::scanf("%ld %*d %*d %ld %ld %ld", &n, &m, &f, &h) == 4) {
    std::vector<CDT::V2d<double>> points(static_cast<std::size_t>(n));
    for (auto& p : points) std::scanf("%lf %lf", &p.x, &p.y);
    CDT::EdgeVec edges;
    for (unsigned a = 0, b = 0; m > 0 && std::scanf("%u %u", &a, &b) == 2; --m)
      edges.emplace_back(a, b);
    for (; h > 0 && std::scanf("%*f %*f") == 0; --h) {
    }
    CDT::RemoveDuplicatesAndRemapEdges(points, edges);
    CDT::Triangulation<double> made(CDT::VertexInsertionOrder::Auto,
                                    CDT::IntersectingConstraintEdges::TryResolve, 0.0);
    made.insertVertices(points);
    made.insertEdges(edges);
    made.eraseSuperTriangle();
    std::printf("nOFF 2\n%zu %zu 0\n", made.vertices.size(), made.triangles.size());
    for (const auto& v : made.vertices) std::printf("%.17g %.17g\n", v.x, v.y);
    for (const auto& t : made.triangles)
      std::printf("3 %u %u %u\n", t.vertices[0], t.vertices[1], t.vertices[2]);
    std::fflush(stdout);
  }
}
