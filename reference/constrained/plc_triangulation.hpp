// A triangulation of a piecewise linear complex (Book: Definitions 4.4, 4.5 and 4.7), and its
// extraction from a CDT of the convex hull.
#pragma once

#include <set>
#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/evolving_cdt.hpp"

namespace circumspect::constrained {

// The simplices of a triangulation that are faces of no other, each with its vertices ascending, in
// lexicographic order, so that two triangulations are the same complex iff they compare equal.
struct PlcTriangulation {
  std::vector<Simplex> simplices;  // the d-simplices: tetrahedra in space, triangles in the plane
  // Dangling: triangles (in space) and edges that are a face of no simplex of higher dimension, and
  // isolated vertices.
  std::vector<Simplex> dangling;

  std::vector<Simplex> simplices_and_dangling() const {
    std::vector<Simplex> all = simplices;
    all.insert(all.end(), dangling.begin(), dangling.end());
    return all;
  }
  bool operator==(const PlcTriangulation&) const = default;
};

// The tetrahedra in the polyhedra of the complex, and its dangling triangles, edges and vertices:
// without the tetrahedra that are joined, through facets that are not walls, to one that contains a
// hole seed or, if the domain is what the polygons enclose, to the outside. Requires: all polygons
// of the complex have been inserted.
PlcTriangulation carve(const PiecewiseLinearComplex& complex, const EvolvingCdt& cdt);

// Does the closed tetrahedron contain the point?
bool holds(const PointSet& points, const Simplex& tetrahedron, const Point& point);

// A triangulation of d-simplices and the faces that must be in it: faces that are in no other
// simplex of it become the dangling ones.
PlcTriangulation with_dangling(std::vector<Simplex> simplices, const std::set<Simplex>& faces);

}  // namespace circumspect::constrained
