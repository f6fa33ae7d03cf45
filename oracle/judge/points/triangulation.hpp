// Are sound simplices a complex that covers the convex hull of the points?
// Book: Definition 2.1 and Section 4.1.
#pragma once

#include <vector>

#include "oracle/judge/points/boundary_facet.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::check {

// All require that judge_simplices found nothing wrong, and say whether every facet lies in one
// or two simplices, two being on opposite sides of it.

// Each of the three looks at the facets, ridges and simplices that it is given. Where somebody else has found
// all that are at fault, it needs no others.

// Condition 1 of docs/theory/points.md alone. `uses` are those of the mesh.
bool judge_facet_matching(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                          Verdict& verdict);

// Condition 2: each boundary ridge lies in exactly two boundary facets, and these do not make a reflex or
// folded angle. `ridges` are the uses of the boundary's own facets.
bool judge_ridges(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                  const std::vector<FacetUse>& ridges, Verdict& verdict);

// Condition 3: the barycentre of the first simplex lies strictly on the inner side of every boundary facet
// and in no other closed simplex.
void judge_sample_point(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                        Verdict& verdict);

// Conditions 1–3 of docs/theory/points.md: linear but for sorting. `uses` are those of the mesh.
bool judge_complex_by_lemma(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                            Verdict& verdict);

// Every two simplices meet in a common face or not at all; and a facet of only one simplex has no
// point beyond it, so that the union is the whole hull.
bool judge_complex_by_definition(const ExactMesh& mesh, Verdict& verdict);

}  // namespace circumspect::check
