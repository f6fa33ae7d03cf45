// Which part of a triangulation a polygon passes through.
// Book: Section 5.8, steps 1 and 2 of FlipInsertPolygon.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "reference/kernel/complex/star_index.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// A polygon f in its plane h = aff f, with the vertices left and right of it.
class PolygonInSpace {
 public:
  // Requires: points in space; the polygon has a triangle. Refers to both.
  PolygonInSpace(const PointSet& points, const Polygon& polygon);

  // d(v, h): how far v is to the right of h along the coordinate axis that the polygon's own axes
  // leave out; zero on h, negative on the left. "This distance is directly proportional to the
  // Euclidean distance, but can be computed without radicals."
  const Rational& distance(Vertex v) const;
  int side(Vertex v) const { return sign(distance(v)); }
  // Has the simplex a vertex on each side? Does it lie in h?
  bool parts(const Simplex& simplex) const;
  bool is_coplanar(const Simplex& simplex) const;

  // Is the part of the segment from the polygon's vertex v to a point of h that is close to v in the
  // polygon? The triangles of the polygon at v tell.
  bool is_inside_near(Vertex v, const Point& towards) const;

  const Polygon& polygon() const { return polygon_; }
  const PointSet& points() const { return points_; }

 private:
  const PointSet& points_;
  const Polygon& polygon_;
  Rational doubled_area_;
  std::map<Vertex, std::vector<Simplex>> triangles_at_;
  mutable std::map<Vertex, Rational> distances_;
};

// The tetrahedra whose interiors meet the polygon.
//
// Such a tetrahedron has a vertex on each side, and its section with h is a convex cell, which is
// either part of the polygon or has no interior point in it: all segments are edges of the
// triangulation and do not cut the cell. For the same reason, where a facet that meets the inside of
// the polygon has a vertex on each side, both its tetrahedra are crossed. So the search need only
// pass such facets, and ask of its first tetrahedra alone whether they are crossed. It may start at
// the polygon's vertices: where it can go no further, an edge in the polygon bounds the cells.
// Requires: all segments of the polygon are edges of the triangulation, which fills a convex hull;
// every vertex of the triangulation in the polygon is one of the polygon's.
std::set<Simplex> crossed_tetrahedra(const StarIndex& tetrahedra, const PolygonInSpace& polygon);

// The facets of the triangulation that are part of the polygon. Requires: as above.
std::set<Simplex> facets_included_in(const StarIndex& tetrahedra, const PolygonInSpace& polygon);

}  // namespace circumspect::constrained
