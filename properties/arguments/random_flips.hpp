// Random triangulations, Delaunay or not, reached by random flips. Book: Section 4.4, the flip
// graph.
#pragma once

#include <iosfwd>
#include <vector>

#include <rapidcheck.h>

#include "inputs/cases.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::properties {

// A triangulation of a point set, printed so that a failing case can be pasted into files. Every
// point is a vertex, whatever the weights.
struct TriangulationCase {
  generators::PointsCase set;
  Triangulation triangulation;

  PointSet points() const { return PointSet(set.points, set.weights); }
};
// As a .node and an .ele file, counted from 0.
std::ostream& operator<<(std::ostream& out, const TriangulationCase& value);

// The flips of all interior facets, one a facet, that are not blocked and keep every vertex: the
// edges of the flip graph at this triangulation (an edge may come up for several facets).
std::vector<delaunay::ExtendedFlip> possible_flips(const PointSet& points,
                                                   const StarIndex& triangulation);

// A walk in the flip graph: each choice takes one of the possible flips, counted cyclically.
// Stops early where no flip is possible.
Triangulation after_flips(const PointSet& points, const Triangulation& start,
                          const std::vector<long>& choices);

// Walks of 0 to `max_flips` random flips, beginning at the Delaunay triangulation of the points
// without their weights. A failing case shrinks to fewer flips of fewer points. In the plane any
// triangulation can come up. Takes sets of any dimension; where their hull has dimension 0 or 1
// there is only one triangulation.
rc::Gen<TriangulationCase> flipped_triangulations(const rc::Gen<generators::PointsCase>& sets,
                                                  std::size_t max_flips);

}  // namespace circumspect::properties
