// Evidence for each kind of fault, as tokens: simplices and points by number from 1, entries of
// simplices from 0, coordinates as integers. Nothing where there is no such fault.
#pragma once

#include <optional>
#include <vector>

#include "oracle/certificate/sidedness.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

struct Evidence {
  Rule rule;  // which the evidence shows to be broken
  std::vector<Integer> because;
};

// Faults of simplices one by one or of their lists of vertices; found by looking.
std::optional<Evidence> simplex_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule);

// Balls that are not empty, points below witness planes, vertices above the lower hull; from the
// witness of the fault.
std::optional<Evidence> ball_evidence(const ExactMesh& mesh, Rule rule, const Witness& witness);

// A point of two simplices off their common face, that of the witness.
std::optional<Evidence> overlap_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule, const Witness& witness);

// A point of the hull that no simplex covers, near a boundary facet beyond which there are points; or,
// if all simplices of the boundary have other ones beyond them, a point of two. The `rule` says which
// fault the verdict found: the hull is not convex, or not closed.
std::optional<Evidence> hull_evidence(const ExactMesh& mesh, const ScaledPoints& points, Rule rule,
                                      const Verdict& verdict);

// A point of the set that no simplex covers. Requires: sound simplices.
std::optional<Evidence> uncovered_point_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                                 Vertex point);

// The number of a simplex that lists these vertices in this order. Requires: there is one.
std::size_t number_of(const ExactMesh& mesh, const Simplex& simplex);

}  // namespace circumspect::certificate
