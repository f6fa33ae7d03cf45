// Are sound simplices a complex that covers the convex hull of the points, and do they have the
// neighbours that a program lists for them (TetGen's and Triangle's .neigh)? Book: Definition 2.1
// and Section 4.1.
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// A facet of only one simplex: a piece of the boundary of the mesh.
struct BoundaryFacet {
  Simplex facet;        // ascending
  Vertex apex;          // the vertex of its simplex off the facet, hence on the inner side
  std::size_t simplex;  // the simplex that has it
  int inner;            // the orientation of the facet with the apex
};

BoundaryFacet boundary_facet(const ExactMesh& mesh, const FacetUse& use);

// All of them, in order of their vertices.
std::vector<BoundaryFacet> boundary_facets(const ExactMesh& mesh,
                                           const std::vector<FacetUse>& uses);

// On which side of the facet is q? 1: on the inner side, strictly; 0: in its hyperplane; −1:
// strictly beyond. `points` is the mesh's configuration or one with further points.
int side_of(const Configuration& points, const BoundaryFacet& facet, Vertex q);

// All three require that judge_simplices found nothing wrong, and return whether every facet lies
// in one simplex or in two on opposite sides of it.

// Each of the three looks only at the facets, ridges and simplices that it is given. If all faulty
// ones are already known, it needs no others.

// Condition 1 of docs/theory/points.md alone. `uses` are those of the mesh.
bool judge_facet_matching(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                          Verdict& verdict);

// Condition 2: each boundary ridge lies in exactly two boundary facets, and these do not make a
// reflex or folded angle. `ridges` are the uses of the boundary's own facets.
bool judge_ridges(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                  const std::vector<FacetUse>& ridges, Verdict& verdict);

// Condition 3: the barycentre of the first simplex lies strictly on the inner side of every
// boundary facet and in no other closed simplex.
void judge_sample_point(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                        Verdict& verdict);

// Conditions 1–3 of docs/theory/points.md, in linear time except for sorting. `uses` are those of
// the mesh.
bool judge_complex_by_lemma(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                            Verdict& verdict);

// complex.wrong-neighbor: entry i of a simplex must be the simplex across the facet opposite its
// vertex i, or none on the boundary. Requires: the mesh lists neighbours; simplices are sound and
// facets lie in one or two of them. `uses` are those of the mesh.
void judge_neighbors(const ExactMesh& mesh, const std::vector<FacetUse>& uses, Verdict& verdict);

// The same for one facet, given that the simplex across it, `across` if there is one, is not the
// listed one. `listed`, `expected`: the indices as the program counts them.
void add_wrong_neighbor(const ExactMesh& mesh, const FacetUse& use, const Simplex* across,
                        Vertex listed, Vertex expected, Verdict& verdict);

// Further demands on a mesh that was judged by definition: that all simplices are listed with the
// same orientation, and that the listed neighbours are the true ones.
void judge_beside_definition(const ExactMesh& mesh, const Options& options, Verdict& verdict);

}  // namespace circumspect::check
