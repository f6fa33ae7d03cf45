// Judges claims about a mesh of points, by lemma: is it a triangulation, is every simplex Delaunay,
// or weighted Delaunay, and are the points that are not vertices submerged?
// Book: Definition 4.1, Lemma 4.1 (the Delaunay Lemma), Sections 2.8 and 5.2 (weights).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/complex/simplex.hpp"
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

// What empty balls imply about other Delaunay triangulations of the same points.

// A point on the sphere of an empty ball makes a cell of the Delaunay subdivision that is not a
// simplex and has more than one triangulation; the canonical one is the one whose balls are also
// empty under the perturbation.
struct Ambiguity {
  bool unique = true;
  bool canonical = true;

  // `side` is in_ball of the simplex and q.
  void see(const PointSet& points, const Simplex& simplex, Vertex q, int side);

  // Reports the facts if the claim holds.
  void conclude(Verdict& verdict) const {
    if (!verdict.holds()) return;
    verdict.unique = unique;
    verdict.canonical = canonical;
  }
};

// A facet of two simplices of a list.
struct SharedFacet {
  Simplex facet;        // its vertices, ascending
  std::size_t simplex;  // the one of them that comes first in the list
  Vertex apex;          // the vertex of the other one off the facet
};

// Is the facet locally Delaunay? If not, it is a violation: see judge_facets_locally_delaunay,
// which asks this about all facets. Returns the side of the ball of the simplex on which the apex
// lies; 1 means inside.
int judge_facet_locally_delaunay(const ExactMesh& mesh, const SharedFacet& shared,
                                 Verdict& verdict);

// The others require sound simplices whose facets lie in one or two of them, two being on opposite
// sides.

// Lemma 4.1: every facet is locally Delaunay. Where the mesh is a triangulation, this is enough for
// its vertices (see judge_submerged_points for the other points of a weighted set). A facet that is
// not breaks delaunay.facet-not-local, or weighted.vertex-submerged if the two simplices show that
// a vertex of it lies strictly above the lower hull.
// `uses` are those of the mesh.
void judge_facets_locally_delaunay(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                   Verdict& verdict, Ambiguity& ambiguity);

// The points of a weighted set that are not vertices: are they submerged? Book: Section 2.8 by way
// of Section 5.2 (weighted Delaunay triangulations).

// Each point that is not a vertex must lie in some simplex (else triangulation.unused-point: a
// point outside is a vertex whatever its weight), its lifted companion on or above the witness
// plane of that simplex (else weighted.point-below-plane). If several simplices contain it, the
// first in the list is meant. Returns how many orientations it took to find the simplices
// (kernel/boxes/point_search.hpp). Requires: the mesh is a triangulation of its vertices, and
// `uses` are those of its facets.
std::uint64_t judge_submerged_points(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                     Verdict& verdict, Ambiguity& ambiguity);

// The same for one point, given the simplex that contains it, or that there is none.
void judge_submerged_point(const ExactMesh& mesh, Vertex q, std::optional<std::size_t> place,
                           Verdict& verdict, Ambiguity& ambiguity);

// The verdict that one of the two claims about balls does not hold, given that the mesh is a
// triangulation of its points and which facets are not locally Delaunay. It is what judge_points()
// says, but looks only at these facets, which may come in any order. `mesh` may be a part of that
// mesh, if the simplices of the facets are in it, and the numbering of points and simplices is in
// the same order. Throws std::logic_error if one of the facets is locally Delaunay. Requires: at
// least one facet, and each facet once.
Verdict not_locally_delaunay(Claim claim, const ExactMesh& mesh, std::vector<SharedFacet> facets,
                             const Options& options = {});

}  // namespace circumspect::check
