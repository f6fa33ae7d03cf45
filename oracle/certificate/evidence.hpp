// Evidence for each kind of fault, as tokens: simplices and points by number from 1, entries of
// simplices from 0, coordinates as integers. Nothing where there is no such fault.
#pragma once

#include <optional>
#include <vector>

#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

struct Evidence {
  Rule rule;  // which the evidence shows to be broken
  std::vector<Integer> because;
};

// For any rule of a mesh of points that the verdict says is broken.
std::optional<Evidence> evidence_for(const ExactMesh& mesh, const Verdict& verdict,
                                     const ScaledPoints& points, Rule rule);

// Faults of simplices one by one or of their lists of vertices; found by looking.
std::optional<Evidence> simplex_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule);

// Balls that are not empty, points below witness planes, vertices above the lower hull; from the
// witness of the fault.
std::optional<Evidence> ball_evidence(const ExactMesh& mesh, Rule rule, const Witness& witness);

// The same where the points do not span: also how the vertices and the point, each times an
// integer, add up to zero. Requires: a witness of a point in the circumball of a simplex.
std::optional<Evidence> flat_ball_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                           const Witness& witness);

// The same of points on a line: a simplex that ends where no other begins, and a point beyond.
// Requires: sound simplices.
std::optional<Evidence> line_end_evidence(const ExactMesh& mesh, const ScaledPoints& points);

// A facet, and two points on different sides of it.
std::optional<Evidence> two_sides_evidence(const ExactMesh& mesh, const Witness& witness);

// Where the facets of a hull end: d points of another facet, one beside them, and a point that is
// in no listed facet.
std::optional<Evidence> uncovered_hull_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                                const Witness& witness);

// Two triangles, and the places of their vertices opposite the edge.
std::optional<Evidence> edge_evidence(const ExactMesh& mesh, const Witness& witness);

// A point of two simplices off their common face, that of the witness.
std::optional<Evidence> overlap_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule, const Witness& witness);

// A point beyond a facet of the boundary, or three facets of the boundary that share a ridge; from
// the witness of the fault.
std::optional<Evidence> hull_evidence(const ExactMesh& mesh, Rule rule, const Witness& witness);

// For each simplex a facet beyond which the point lies: none covers it. Requires: sound simplices.
std::optional<Evidence> uncovered_point_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                                 Vertex point);

// The number of a simplex that lists these vertices, in any order: the checkers of domains turn
// simplices around. Nothing if none does, for they also speak of faces.
std::optional<std::size_t> number_of(const ExactMesh& mesh, const Simplex& simplex);

}  // namespace circumspect::certificate
