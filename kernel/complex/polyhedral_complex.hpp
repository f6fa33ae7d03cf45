// Polyhedral complexes with convex cells, such as the Delaunay subdivision.
// Book: Section 4.2 ("a polyhedral complex called the Delaunay subdivision of S").
#pragma once

#include <map>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polytope.hpp"

namespace circumspect {

// A k-dimensional polyhedral complex: its cells and all their faces, by dimension, each face as the
// set of all points on it. Two complexes are the same iff they compare equal.
class PolyhedralComplex {
 public:
  // From its k-faces, each with all its points. Dimension −1, without cells, is the empty complex.
  // Requires: every cell has the dimension k; two cells meet in a shared face or not at all.
  PolyhedralComplex(const PointSet& points, int dimension, std::vector<Face> cells,
                    const FacetsOfPolytope& facets_of);

  int dimension() const { return static_cast<int>(faces_.size()) - 1; }
  // The j-faces in lexicographic order. Requires: 0 ≤ j ≤ dimension().
  const std::vector<Face>& faces(int j) const { return faces_[static_cast<std::size_t>(j)]; }
  // The k-faces; the empty complex has none.
  std::vector<Face> cells() const { return faces_.empty() ? std::vector<Face>{} : faces_.back(); }
  // The facets of a face: the faces of one dimension less that bound it. Requires: one of faces().
  const std::vector<Face>& facets_of(const Face& face) const { return facets_.at(face); }
  // The vertices of a face: those of its points that are 0-faces.
  Simplex vertices_of(const Face& face) const;
  // Is every face a simplex?
  bool is_simplicial() const;

  bool operator==(const PolyhedralComplex&) const = default;

 private:
  std::vector<std::vector<Face>> faces_;  // by dimension
  std::map<Face, std::vector<Face>> facets_;
};

}  // namespace circumspect
