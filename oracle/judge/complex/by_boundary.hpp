// Do simplices of full dimension form a complex? Asked of their facets and of the boundary alone.
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/configuration.hpp"

namespace circumspect::check {

// Three conditions, which docs/theory/complex.md proves to be the definition:
// 1. each facet is in one or two simplices, and two are on opposite sides of it;
// 2. the facets of one simplex, the boundary, form a complex;
// 3. no simplex is just outside of the boundary, which is asked once of each class of facets that
//    are joined by a ridge of two.
// The simplices that are left out for the others to fulfil them: none if all form a complex. Every
// two that do not meet as they should are at least one of these. There may be more than are needed,
// and are all if many break a condition.
// Requires: each of d + 1 vertices, affinely independent, no two with the same vertices, no two
// points of theirs equal; `positions` are the points.
std::vector<std::size_t> left_out_of_complex(const Configuration& points,
                                             const std::vector<Point>& positions,
                                             const std::vector<Simplex>& simplices);

// The parts of this that somebody else may ask, who knows the boundary.

// Condition 2: the facets that do not meet another as they should, by their places. `positions` are
// those of `points`.
std::vector<std::size_t> improper_facets(const Configuration& points,
                                         const std::vector<Point>& positions,
                                         const std::vector<Simplex>& facets);

// The class of each facet: the place of one of them, which is in it.
std::vector<std::size_t> class_of_each(const std::vector<Simplex>& facets);

// Does a closed simplex hold the points next to the centre of a facet that are on the other side
// than `apex`? By their corners.
bool has_just_outside(const std::vector<Point>& simplex, const std::vector<Point>& facet,
                      const Point& apex);

}  // namespace circumspect::check
