// Is every simplex Delaunay? Book: Definition 4.1 and Lemma 4.1 (the Delaunay Lemma).
#pragma once

#include "oracle/mesh.hpp"
#include "oracle/verdict.hpp"

namespace circumspect::check {

// Both require sound simplices whose facets lie in one or two of them, two being on opposite sides.
// Both set `unique` and `canonical` if the claim holds.

// Lemma 4.1: every facet is locally Delaunay. Where the mesh is a triangulation, this is enough.
void judge_facets_locally_delaunay(const Mesh& mesh, Verdict& verdict);

// Definition 4.1: no open circumball of a simplex contains a point of S.
void judge_balls_empty(const Mesh& mesh, Verdict& verdict);

}  // namespace circumspect::check
