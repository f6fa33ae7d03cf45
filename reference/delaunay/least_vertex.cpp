#include "reference/delaunay/least_vertex.hpp"

#include <algorithm>
#include <map>

namespace circumspect::delaunay {

Triangulation least_vertex_triangulation(const PointSet& points, const PolyhedralComplex& complex) {
  const Configuration& configuration = points.configuration();
  std::map<Face, std::vector<Simplex>> triangulated;
  for (int j = 0; j <= complex.dimension(); ++j) {
    for (const Face& face : complex.faces(j)) {
      const Vertex least = *std::min_element(face.begin(), face.end(), [&](Vertex a, Vertex b) {
        return configuration.rank(a) < configuration.rank(b);
      });
      std::vector<Simplex>& simplices = triangulated[face];
      if (j == 0) simplices = {{least}};
      for (const Face& facet : complex.facets_of(face)) {
        if (contains(facet, least)) continue;
        for (Simplex simplex : triangulated.at(facet)) {
          simplex.push_back(least);
          simplices.push_back(std::move(simplex));
        }
      }
    }
  }
  std::vector<Simplex> all;
  for (const Face& cell : complex.cells()) {
    all.insert(all.end(), triangulated.at(cell).begin(), triangulated.at(cell).end());
  }
  return Triangulation(complex.dimension(), std::move(all));
}

}  // namespace circumspect::delaunay
