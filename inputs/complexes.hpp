// Random piecewise linear complexes for RapidCheck, by family, edge-protected or not; those that are
// sure to be need a Delaunay triangulation, and are in inputs/triangulated. All are valid, small,
// and shrink by dropping cells and vertices. Point sets must not be empty.
#pragma once

#include <cstddef>

#include "inputs/complex_case.hpp"
#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// The largest of three sets each, for small ones leave no room for cells; the origin if all are empty,
// for without a vertex nothing tells the dimension of a complex.
PointSets rather_large(const PointSets& sets, std::size_t dimension);

// Triangles, quadrilaterals of coplanar points and segments among the points of a set of space, at
// random as long as they do not cross; any edges. Dangling and isolated cells, open surfaces, slits in
// polygons; mostly not edge-protected, so that a CDT may exist or not (Book: Section 4.5.3). Of the
// hull kind, or enclosed, which then may well enclose nothing.
Complexes scattered_cells(const PointSets& sets);

// Tetrahedra of random points, glued facet to facet, whose boundary becomes the polygons of an
// enclosed domain, and some of the facets between them too: polyhedra, convex or not, that have a
// triangulation, but not always a CDT (Book: Section 4.5.2, "some polyhedra that do have
// triangulations do not have CDTs"). Other points are isolated vertices.
Complexes glued_tetrahedra(const PointSets& sets);

// A cube with vertices in its faces and inside, whose faces have holes, slits and polygons within a
// polygon, with a smaller box inside that is or is not a cavity, with dangling polygons and segments
// (Book: Definition 4.3, Figures 2.6 and 4.11).
Complexes furnished_boxes();

// Schönhardt's polyhedron and its kin, prisms over a triangle or a square that are twisted, with
// corners moved at random and sometimes a vertex inside (Book: Figure 4.10).
Complexes twisted_prisms();

// One of the families above, with point sets generic and degenerate, at most `max_points` of them
// where the family leaves a choice.
Complexes any_complex(std::size_t max_points);

// In the plane: segments that do not cross, hole seeds, both kinds (Book: Sections 2.10 and 3.10).
Complexes planar_complexes(std::size_t max_points);
Complexes planar_complexes(const PointSets& sets);

}  // namespace circumspect::generators
