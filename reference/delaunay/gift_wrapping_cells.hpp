// Gift-wrapping whole cells of cospherical points, without any perturbation.
// Book: Section 5.6, Exercise 4 of Chapter 5 (Figures 3.14 and 4.4).
#pragma once

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polyhedral_complex.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// The Delaunay subdivision, cell by cell. To finish a facet, find a point in front whose ball with
// the facet has no other in front inside, and then *all* points on that ball: together they are the
// cell. The dictionary holds facets of cells, each known by all the points on it, so the two cells
// at a facet agree about it whatever they are made of, and no cell is ever wrapped in part.
//
// Triangulating the cells afterwards stays consistent because it is decided face by face, in order
// of increasing dimension (least_vertex_triangulation), never cell by cell.
PolyhedralComplex gift_wrapping_cells(const PointSet& points);

// The canonical triangulation from it.
Triangulation gift_wrapping_by_cells(const PointSet& points);

}  // namespace circumspect::delaunay
