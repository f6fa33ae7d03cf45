// Is every simplex Delaunay? Book: Section 4.2, Definition 4.1; with weights Section 5.2, by the
// lifting map.
#pragma once

#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// "The open circumball of a simplex contains no point in S" (delaunay.vertex-in-ball); with
// weights, no lifted point lies strictly below its witness plane (weighted.point-below-plane).
// Every simplex, every point. If the claim then holds, Verdict::unique says that no point is on the
// sphere of a ball either, and Verdict::canonical that none is inside under the canonical
// perturbation.
// Requires: simplices of the dimension of the points, affinely independent.
void judge_balls_are_empty(const ExactMesh& mesh, Verdict& verdict);

// The same of simplices of lower dimension, which have many circumballs: "there exists an open
// circumball of σ that contains no point in S" (delaunay.no-empty-ball).
void judge_some_ball_is_empty(const PointSet& points, const std::vector<Simplex>& simplices,
                              Verdict& verdict);

}  // namespace circumspect::definition
