// The facets of the convex hull of some points, simplicial or not.
// Book: Section 4.2 (the faces of conv S⁺ and of the cells of the Delaunay subdivision).
#pragma once

#include <functional>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect {

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

}  // namespace circumspect
