#include "kernel/complex/polyhedral_complex.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polytope.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect {

PolyhedralComplex::PolyhedralComplex(const PointSet& points, int dimension, std::vector<Face> cells,
                                     const FacetsOfPolytope& facets_of)
    : faces_(static_cast<std::size_t>(dimension + 1)) {
  std::set<Face> faces;
  for (Face& cell : cells) faces.insert(sorted(std::move(cell)));
  for (std::size_t j = faces_.size(); j-- > 0;) {
    faces_[j].assign(faces.begin(), faces.end());
    faces.clear();
    for (const Face& face : faces_[j]) {
      std::vector<Face> facets = facets_of(points, face);
      faces.insert(facets.begin(), facets.end());
      facets_.emplace(face, std::move(facets));
    }
  }
}

Simplex PolyhedralComplex::vertices_of(const Face& face) const {
  Simplex vertices;
  std::copy_if(face.begin(), face.end(), std::back_inserter(vertices),
               [&](Vertex v) { return facets_.count({v}) == 1; });
  return vertices;
}

bool PolyhedralComplex::is_simplicial() const {
  const std::vector<Face> all = cells();
  return std::all_of(all.begin(), all.end(), [&](const Face& cell) {
    return static_cast<int>(cell.size()) == dimension() + 1;
  });
}

}  // namespace circumspect
