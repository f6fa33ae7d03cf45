// The constrained Delaunay triangulation of a planar complex: of a polygon in its own plane, or of
// a PLC in the plane. Book: Sections 3.10 and 3.11, which Section 5.6 uses; Proposition 4.11.
#pragma once

#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::constrained {

// The edges of the convex hull of some coplanar vertices, whose plane projects injectively on the
// two axes, cut at every vertex that lies on them; each ascending, in lexicographic order. If all
// the vertices lie on one line, these are the edges between successive ones.
std::vector<Simplex> hull_edges(const PointSet& points, const std::vector<std::size_t>& axes,
                                std::vector<Vertex> vertices);

// The input of a planar triangulation (Proposition 4.11: the faces of a polygon are a
// two-dimensional PLC): a polygon with these vertices, and with these segments and (for the hull
// kind) the edges of the hull as segments. It is the union of the bounded components of the
// complement of its segments, without those that hold a hole seed (the hull kind has no holes); so
// it need not be connected, and it is empty if nothing is enclosed. Requires: as for
// `polygon_triangles`.
Polygon planar_domain(const PointSet& points, const std::vector<std::size_t>& axes,
                      const std::vector<Vertex>& vertices, std::vector<Simplex> segments,
                      const std::vector<Point>& hole_seeds, DomainKind kind);

enum class PlanarAlgorithm {
  kGiftWrapping,  // Section 3.11: every segment is a seed, on each side that must be triangulated
  kSegmentInsertion  // Section 3.10: segments are inserted into the Delaunay triangulation
};

// The triangles, ascending, of the canonical CDT of a polygon, which may have holes, slits and
// vertices inside. In the plane every PLC has a CDT; under the canonical perturbation there is only
// one. Everything happens on the polygon's two axes; its own triangles tell what belongs to it.
std::vector<Simplex> planar_cdt(const PointSet& points, const Polygon& polygon,
                                PlanarAlgorithm algorithm = PlanarAlgorithm::kGiftWrapping);

// The canonical CDT of a PLC in the plane. For the hull kind, the edges of the convex hull count as
// segments. The segments that are in no triangle, and the isolated vertices outside, dangle. (A
// hull without area has nothing inside.) Requires: complex.ambient_dimension() == 2.
PlcTriangulation planar_cdt(const PiecewiseLinearComplex& complex,
                            PlanarAlgorithm algorithm = PlanarAlgorithm::kGiftWrapping);

}  // namespace circumspect::constrained
