// Judges claims about a mesh of points, by lemma.
#pragma once

#include <vector>

#include "oracle/judge/points/delaunay.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Does the claim hold?
// `triangulation`: a simplicial complex whose vertices are the points and whose union is their
// convex hull; weights play no part. Book: Definition 2.1, Section 4.1.
// `delaunay`: the same, and every simplex is Delaunay. Book: Definition 4.1, Lemma 4.1.
// `weighted-delaunay`: a triangulation of some of the points, whose union is the convex hull of
// all, such that no lifted point lies strictly below the witness plane of a simplex. Points on the
// lower hull that are not extreme may be vertices or not. Where all weights are equal, it is the
// claim `delaunay`. Book: Section 5.2.
// Requires: one of these claims, by lemma; no weights for `delaunay`.
Verdict judge_points(Claim claim, const ExactMesh& mesh, const Options& options = {});

// Further demands on a mesh that was judged by definition: that all simplices are listed with the
// same orientation, and that the listed neighbours are the true ones.
void judge_beside_definition(const ExactMesh& mesh, const Options& options, Verdict& verdict);

// The verdict that one of the two claims about balls does not hold, given that the mesh is a
// triangulation of its points and which facets are not locally Delaunay. It is what judge_points()
// says, but looks only at these facets, which may come in any order. `mesh` may be a part of that
// mesh, if the simplices of the facets are in it, and the numbering of points and simplices is in
// the same order. Throws std::logic_error if one of the facets is locally Delaunay. Requires: at
// least one facet, and each facet once.
Verdict not_locally_delaunay(Claim claim, const ExactMesh& mesh, std::vector<SharedFacet> facets,
                             const Options& options = {});

}  // namespace circumspect::check
