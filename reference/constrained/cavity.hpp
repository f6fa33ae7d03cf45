// The part of a CDT that a polygon passes through, and the cavities that are evacuated and filled
// there. Book: Sections 5.6 and 5.8.
#pragma once

#include <map>
#include <set>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/star_index.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::constrained {

// Which part of a triangulation a polygon passes through.
// Book: Section 5.8, steps 1 and 2 of FlipInsertPolygon.

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
  // Does the simplex have a vertex on each side? Does it lie in h?
  bool parts(const Simplex& simplex) const;
  bool is_coplanar(const Simplex& simplex) const;

  // Is the part of the segment from the polygon's vertex v to a point of h that is close to v in
  // the polygon? The triangles of the polygon at v tell.
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
// triangulation and do not cut the cell. For the same reason, where a facet that meets the inside
// of the polygon has a vertex on each side, both its tetrahedra are crossed. So the search only
// needs to pass such facets, and to test only its first tetrahedra. It may start at the polygon's
// vertices: where it can go no further, an edge in the polygon bounds the cells. Requires: all
// segments of the polygon are edges of the triangulation, which fills a convex hull; every vertex
// of the triangulation in the polygon is one of the polygon's.
std::set<Simplex> crossed_tetrahedra(const StarIndex& tetrahedra, const PolygonInSpace& polygon);

// The facets of the triangulation that are part of the polygon. Requires: as above.
std::set<Simplex> facets_included_in(const StarIndex& tetrahedra, const PolygonInSpace& polygon);

// Cavities of a CDT: filling one by gift-wrapping, and inserting and deleting polygons in this way.
// Book: Section 5.6 ("retriangulating the cavity evacuated when a vertex is deleted from a … CDT,
// or when a polygon is inserted or deleted"), Section 5.8 ("the obvious algorithm").

// A cavity in space or in a plane, its facets oriented with the cavity in front; walls that run
// through it (in a plane: segments) are among them in both orientations.
struct Cavity {
  std::vector<std::size_t> axes;  // coordinates of the plane or of space
  UnfinishedFacets facets;
  std::vector<Vertex> candidates;
};

// The cavity that is left when simplices of the dimension of `axes` are deleted. Their facets that
// are among the walls stay, and so do those that only one of the simplices has; all vertices stay
// as candidates.
Cavity cavity_of(const PointSet& points, const std::vector<std::size_t>& axes,
                 const std::set<Simplex>& walls, const std::vector<Simplex>& deleted);

// Simplices that fill the cavity exactly, ascending, or the facet at which the wrapping failed.
//
// A candidate in front of a facet counts only if no facet of the cavity reaches into its simplex
// with the facet. If the cavity is a union of simplices of a CDT, this finds the right one: it
// counts, and any other that counts is visible from the facet, and so cannot be in its ball.
// Otherwise the result has a facet that is not locally Delaunay (Lemma 4.10), which the caller has
// to check.
//
// A wrapping that ends has filled the cavity: the boundary of the simplices, with orientation, is
// that of the cavity, so they cover each point as often, once within and never without. It ends
// because no facet ever has two simplices on one side, and so no simplex comes twice.
tl::expected<std::vector<Simplex>, NoChange> gift_wrap_cavity(const PointSet& points,
                                                              const Cavity& cavity);

// "Delete the tetrahedra whose interiors intersect f. All the simplices not deleted are still
// constrained Delaunay. Then retriangulate the polyhedral cavities on either side of f." Turns the
// CDT of P into that of P ∪ {f}, or says why this is impossible and changes nothing. Requires: the
// CDT is that of a PLC P in which all vertices of the points that are in f are vertices, and P ∪
// {f} is a valid PLC; it fills a convex hull, so that f does not leave it, which is asserted.
std::optional<NoChange> insert_polygon_by_cavity(const PointSet& points, EvolvingCdt& cdt,
                                                 const Polygon& polygon);

// Turns the CDT of P into that of P \ {f}, or says why this is impossible and changes nothing. The
// segments of f stay.
//
// The facets in f that are not locally Delaunay must go, with the tetrahedra at them. It is not
// known in advance which other tetrahedra must: the cavity grows over a facet that turns out not to
// be locally Delaunay after the wrapping, and over all its facets where the wrapping fails. In the
// end it holds all tetrahedra that are no longer constrained Delaunay, if P \ {f} has a CDT.
// Requires: f is a polygon of P; the CDT fills a convex hull, which is asserted of the facets in f.
std::optional<NoChange> delete_polygon(const PointSet& points, EvolvingCdt& cdt,
                                       const Polygon& polygon);

}  // namespace circumspect::constrained
