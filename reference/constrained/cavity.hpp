// Cavities of a CDT: filling one by gift-wrapping, and polygons that are inserted and deleted so.
// Book: Section 5.6 ("retriangulating the cavity evacuated when a vertex is deleted from a … CDT,
// or when a polygon is inserted or deleted"), Section 5.8 ("the obvious algorithm").
#pragma once

#include <tl/expected.hpp>

#include "reference/constrained/evolving_cdt.hpp"
#include "reference/kernel/complex/dictionary.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// A cavity in space or in a plane, its facets oriented with the cavity in front; walls that run
// through it (in a plane: segments) are among them in both orientations.
struct Cavity {
  std::vector<std::size_t> axes;  // coordinates of the plane or of space
  UnfinishedFacets facets;
  std::vector<Vertex> candidates;
};

// The cavity that is left when simplices of the dimension of `axes` are deleted. Their facets that
// are among the walls stay, and so do those that only one of the simplices has; all vertices stay
// for candidates.
Cavity cavity_of(const PointSet& points, const std::vector<std::size_t>& axes,
                 const std::set<Simplex>& walls, const std::vector<Simplex>& deleted);

// Simplices that fill the cavity exactly, ascending, or the facet at which the wrapping failed.
//
// Of the candidates in front of a facet only those count whose simplex with the facet no facet of
// the cavity reaches into. If the cavity is a union of simplices of a CDT this finds the right one:
// it counts, and any other that counts is visible from the facet, and so cannot be in its ball.
// Otherwise whatever comes out has a facet that is not locally Delaunay (Lemma 4.10), which is left
// to the caller.
//
// A wrapping that ends has filled the cavity: the boundary of the simplices, with orientation, is
// that of the cavity, so they cover each point as often, once within and never without. It ends
// because no facet ever has two simplices on one side, and so no simplex comes twice.
tl::expected<std::vector<Simplex>, NoChange> gift_wrap_cavity(const PointSet& points,
                                                              const Cavity& cavity);

// "Delete the tetrahedra whose interiors intersect f. All the simplices not deleted are still
// constrained Delaunay. Then retriangulate the polyhedral cavities on either side of f." Makes the
// CDT of P that of P ∪ {f}, or says why it cannot be done, and then nothing has changed.
// Requires: the CDT is that of a PLC P in which all vertices of the points that are in f are
// vertices, and P ∪ {f} is a valid PLC; it fills a convex hull, so that f does not leave it, which
// is asserted.
std::optional<NoChange> insert_polygon_by_cavity(const PointSet& points, EvolvingCdt& cdt,
                                                 const Polygon& polygon);

// Makes the CDT of P that of P \ {f}, or says why it cannot be done, and then nothing has changed.
// The segments of f stay.
//
// The facets in f that are not locally Delaunay must go, with the tetrahedra at them. Nobody says
// beforehand which other tetrahedra must: the cavity grows over a facet that is found not to be
// locally Delaunay after the wrapping, and over all its facets where the wrapping fails. In the end
// it holds all tetrahedra that are not constrained Delaunay any more, if P \ {f} has a CDT.
// Requires: f is a polygon of P; the CDT fills a convex hull, which is asserted of the facets in f.
std::optional<NoChange> delete_polygon(const PointSet& points, EvolvingCdt& cdt,
                                       const Polygon& polygon);

}  // namespace circumspect::constrained
