// Convex polytopes, and complexes of them.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect {

// ---- Polytope ----
// The facets of the convex hull of some points, simplicial or not.
// Book: Section 4.2 (the faces of conv S⁺ and of the cells of the Delaunay subdivision).

// A convex polytope, or a face of one: all points of a set that lie on it, in ascending order. In
// an unweighted Delaunay subdivision these are its vertices; on a weighted one they may also be
// points of a face that are not extreme. Its dimension is that of its affine hull.
using Face = std::vector<Vertex>;

// The facets of the polytope, each with all of its points, in lexicographic order. A single point
// has no facets here. Requires: the polytope is not empty.
using FacetsOfPolytope = std::function<std::vector<Face>(const PointSet&, const Face&)>;

// By definition: for every k of its points, does their hyperplane have all points on one side?
std::vector<Face> facets_by_definition(const PointSet& points, const Face& polytope);

// By gift-wrapping: starting from one facet, finds the facet on the other side of each ridge
// (D. Chand and S. Kapur, J. ACM 17, 1970). The ridges are the facets' facets, found in the same
// way.
std::vector<Face> facets_by_wrapping(const PointSet& points, const Face& polytope);

// One facet of the convex hull of the members projected on the axes, with all members on it.
// Found by recursion on the dimension: a facet of the projection on fewer axes carries a vertical
// supporting hyperplane, which is turned about what it touches. Requires: at least one axis; the
// projected members span all axes.
Face some_facet(const PointSet& points, const std::vector<std::size_t>& axes,
                const std::vector<Vertex>& members);

// ---- Polyhedral complex ----
// Polyhedral complexes with convex cells, such as the Delaunay subdivision.
// Book: Section 4.2 ("a polyhedral complex called the Delaunay subdivision of S").

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
