// Random piecewise linear complexes, by family, edge-protected or not; families that are certain to
// be edge-protected need a Delaunay triangulation, and are in inputs/triangulated. All are valid
// and small. Point sets must not be empty.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"

namespace circumspect::generators {

// The largest of three sets that draw() returns, because small ones leave no room for cells; the
// origin if all are empty, because a complex without vertices has no dimension.
template <class Draw>
std::vector<Point> rather_large(std::size_t dimension, const Draw& draw) {
  std::vector<Point> largest;
  for (int i = 0; i < 3; ++i) {
    std::vector<Point> points = draw();
    if (points.size() > largest.size()) largest = std::move(points);
  }
  return largest.empty() ? std::vector<Point>{Point(dimension)} : largest;
}

// Triangles, quadrilaterals of coplanar points and segments among the points of a set of space, at
// random as long as they do not cross; any edges. There are dangling and isolated cells, open
// surfaces, and slits in polygons; mostly not edge-protected, so that a CDT may exist or not (Book:
// Section 4.5.3). The kind is hull or enclosed, and the latter often encloses nothing.
ComplexCase scattered_cells(Dice& dice, std::vector<Point> points);

// Tetrahedra of random points, glued facet to facet, whose boundary becomes the polygons of an
// enclosed domain, and some of the facets between them too: polyhedra, convex or not, that have a
// triangulation, but not always a CDT (Book: Section 4.5.2, "some polyhedra that do have
// triangulations do not have CDTs"). Other points are isolated vertices.
ComplexCase glued_tetrahedra(Dice& dice, std::vector<Point> points);

// A cube with vertices in its faces and inside, whose faces have holes, slits and polygons within a
// polygon, with a smaller box inside that is or is not a cavity, with dangling polygons and
// segments (Book: Definition 4.3, Figures 2.6 and 4.11).
ComplexCase furnished_box(Dice& dice);

// Schönhardt's polyhedron and its kin, prisms over a triangle or a square that are twisted, with
// corners moved at random and sometimes a vertex inside (Book: Figure 4.10).
ComplexCase twisted_prism(Dice& dice);

// In the plane: segments that do not cross, hole seeds, both kinds (Book: Sections 2.10 and 3.10).
ComplexCase planar_complex(Dice& dice, std::vector<Point> points);

}  // namespace circumspect::generators
