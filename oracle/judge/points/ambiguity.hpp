// What empty balls say about other Delaunay triangulations of the same points.
#pragma once

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "reference/kernel/predicates/perturbation.hpp"

namespace circumspect::check {

// A point on the sphere of an empty ball makes a cell of the Delaunay subdivision that is no simplex
// and has more than one triangulation; of these the canonical one has empty balls under the
// perturbation too.
struct Ambiguity {
  bool unique = true;
  bool canonical = true;

  // `side` is in_ball of the simplex and q.
  void see(const PointSet& points, const Simplex& simplex, Vertex q, int side) {
    if (side != 0) return;
    unique = false;
    if (canonical) canonical = perturbed_in_ball(points.configuration(), simplex, q) < 0;
  }

  // Reports the facts if the claim holds.
  void conclude(Verdict& verdict) const {
    if (!verdict.holds()) return;
    verdict.unique = unique;
    verdict.canonical = canonical;
  }
};

}  // namespace circumspect::check
