// A conforming (Steiner) Delaunay triangulation, and the triangles whose unions are its polygons.
// Book: Definition 4.5, Section 4.5.3.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/constrained/split_segments.hpp"

namespace circumspect::constrained {

// The triangles whose union a polygon must become. Book: Section 4.5.3 ("every polygon is a union
// of Delaunay (preferably strongly Delaunay) triangles").

// The triangles of the canonical Delaunay triangulation of some points of the polygon that are in
// it. If the segments of the polygon are unions of edges, the polygon is the union of these
// triangles. If the polygon is a union of triangles of a triangulation of more points under the
// canonical perturbation, these are the triangles in it. Requires: `vertices` are the polygon's,
// and others that have been added in it.
std::vector<Simplex> subfacets(const PointSet& points, const Polygon& polygon,
                               const std::vector<Vertex>& vertices);

// Does the polygon contain this point of its plane?
bool is_in_polygon(const PointSet& points, const Polygon& polygon, const Point& point);

// A point in the plane of the polygon, at most a quarter of the circumradius from the circumcentre
// of the triangle. Its coordinates on the polygon's axes are dyadic and as short as that allows:
// exact circumcentres of triangles of circumcentres would soon have thousands of digits.
Point near_circumcentre(const PointSet& points, const Polygon& polygon, const Ball& circumball);

// Do two segments in the plane of the polygon have a common point?
bool do_meet(const std::vector<std::size_t>& axes, const Point& a, const Point& b, const Point& c,
             const Point& d);

struct ConformingDelaunay {
  PiecewiseLinearComplex complex;  // the augmented complex: the original points come first
  PlcTriangulation triangulation;  // part of the canonical Delaunay triangulation of its vertices
  std::vector<PointOnSegment> on_segments;  // in the order of their indices, which run through both
  std::vector<PointInPolygon> in_polygons;
};

// Adds vertices until every segment is a union of edges, and every polygon a union of triangles, of
// the canonical Delaunay triangulation of all vertices. (Under the perturbation these are strongly
// Delaunay.) Then the part of that triangulation in the domain is a Steiner Delaunay triangulation
// of the complex.
//
// In the plane, splitting segments as in steiner_cdt.hpp suffices, and always ends.
//
// In space, that comes first. Then a polygon is a union of the Delaunay triangles of the vertices
// in it, the subfacets. If a subfacet is missing from the Delaunay triangulation in space, the
// segments of its polygon are split until the diametral balls of their subsegments are empty. If it
// is still missing, a point near its circumcentre is added to the polygon. But if that point would
// be in the diametral ball of a subsegment of a segment of the polygon, or outside the polygon,
// then the subsegment that is in the way is split instead.
//
// That ends where no two cells meet at an angle below 90°. Let the subsegments of the polygon's
// segments have empty diametral balls; sooner or later they do, see steiner_cdt.hpp. A
// subfacet is only missing if its smallest circumball contains a vertex v off the polygon. v is not
// on a cell that meets the polygon: beyond a common segment or vertex, v would be in the diametral
// ball of a subsegment of the polygon's boundary. So subfacets that are smaller than the distance
// of the polygon from all cells that it does not meet are there. The points added to the polygon
// keep a distance from each other and from all vertices in it that is at least half a missing
// subfacet's radius; so they are finitely many. So are the points on its segments that give way to
// them.
//
// Cells that meet at smaller angles may add points to each other for ever; therefore the limit.
// "There are algorithms that can find a Steiner Delaunay tetrahedralization of any
// three-dimensional polyhedron, but they might introduce a superpolynomial number of new vertices":
// this is not one of them. Requires: the complex is valid.
tl::expected<ConformingDelaunay, SteinerLimitReached> conforming_delaunay(
    const PiecewiseLinearComplex& complex, std::size_t most_steiner_points);

}  // namespace circumspect::constrained
