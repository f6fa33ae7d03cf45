// Filling a cavity of a CDT by gift-wrapping. Book: Section 5.6 ("retriangulating the cavity
// evacuated when a vertex is deleted from a … CDT, or when a polygon is inserted or deleted").
#pragma once

#include <tl/expected.hpp>

#include "reference/complex/unfinished_facets.hpp"
#include "reference/constrained/evolving_cdt.hpp"

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

}  // namespace circumspect::constrained
