// Is every simplex Delaunay, or weighted Delaunay? Book: Definition 4.1, Lemma 4.1 (the Delaunay
// Lemma), Section 5.2 (weights).
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/judge/points/ambiguity.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::check {

// A facet of two simplices of a list.
struct SharedFacet {
  Simplex facet;        // its vertices, ascending
  std::size_t simplex;  // the one of them that comes first in the list
  Vertex apex;          // the vertex of the other one off the facet
};

// Is the facet locally Delaunay? If not, it is a violation: see judge_facets_locally_delaunay, which asks
// this of all facets. Returns the side of the ball of the simplex on which the apex lies: 1: inside.
int judge_facet_locally_delaunay(const ExactMesh& mesh, const SharedFacet& shared,
                                 Verdict& verdict);

// The others require sound simplices whose facets lie in one or two of them, two being on opposite sides.

// Lemma 4.1: every facet is locally Delaunay. Where the mesh is a triangulation, this is enough for
// its vertices (see judge_submerged_points for the other points of a weighted set). A facet that is
// not breaks delaunay.facet-not-local, or weighted.vertex-submerged if the two simplices show that
// a vertex of it lies strictly above the lower hull.
// `uses` are those of the mesh.
void judge_facets_locally_delaunay(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                   Verdict& verdict, Ambiguity& ambiguity);

// Definition 4.1: no open circumball of a simplex contains a point of S (delaunay.vertex-in-ball);
// weighted: no lifted point of S lies strictly below a witness plane (weighted.point-below-plane).
void judge_balls_empty(const ExactMesh& mesh, Verdict& verdict, Ambiguity& ambiguity);

}  // namespace circumspect::check
