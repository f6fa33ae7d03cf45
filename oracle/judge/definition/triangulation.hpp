// Is a simplicial complex a triangulation of a point set? Book: Definition 2.1, quoted in Section
// 4.1: "a simplicial complex whose vertices are the points and whose union is the convex hull of
// the points".
#pragma once

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// The vertices are the points: no point is without a simplex (triangulation.unused-point).
void judge_vertices_are_points(const ExactMesh& mesh, Verdict& verdict);

// The union is the convex hull: no point lies strictly beyond a facet that only one simplex has, or
// else the rule is broken. Why that is the definition: all vertices are points, so nothing outside
// of conv S is covered. If something in its interior is not, a generic path to there from a covered
// point leaves the union through such a facet, strictly inside of conv S, so that points lie
// beyond.
// Requires: the mesh is a simplicial complex. If it has no simplex, nothing is said.
void judge_union_is_hull(const ExactMesh& mesh, Rule rule, Verdict& verdict);

}  // namespace circumspect::definition
