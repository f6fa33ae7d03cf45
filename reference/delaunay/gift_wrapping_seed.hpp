// A facet to start gift-wrapping from. Book: Section 5.6 ("seed the algorithm with one strongly
// Delaunay triangle").
#pragma once

#include "reference/complex/point_set.hpp"

namespace circumspect::delaunay {

// A facet of the canonical triangulation that lies on the convex hull. All points on a facet of the
// hull have, by recursion on the dimension, a canonical simplex of their own, under the perturbation
// in their flat; this is a facet of the canonical triangulation of the whole set. The book's recipe
// below needs a generic set without weights; this one needs nothing.
// Requires: points.dimension() ≥ 1.
Simplex hull_facet_seed(const PointSet& points);

// The recipe of the book: an arbitrary point, its nearest neighbour, then again and again the point
// that minimises the radius of the smallest circumball of the simplex with one vertex more. Why it
// works: the ball with the first edge for its diameter is empty, the neighbour being nearest. And if
// the smallest circumball of a simplex is empty, so is that of the simplex with the best point more:
// the balls through the simplex grow on from the empty one, within the flat that a point inside the
// new ball would span with the simplex, and would have met that point at a smaller radius.
// Requires: points.dimension() ≥ 1; the set is generic (Definition 4.2) and not weighted.
Simplex nearest_neighbour_seed(const PointSet& points);

}  // namespace circumspect::delaunay
