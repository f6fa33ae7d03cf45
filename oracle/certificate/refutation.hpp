// What proves that a claim does not hold of a mesh: one fault, with the evidence by which it can be
// seen. proofs/CERTIFICATE.md says which evidence each rule takes.
#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

struct Refutation {
  Claim claim;
  Rule rule;
  std::vector<Integer> because;    // the tokens of the evidence
  std::vector<std::size_t> basis;  // points that span the plane or space
};

// Of the rules that the verdict says are broken the first that can be shown. Linear in the mesh. Nothing
// if all that is broken is no part of the claim: simplex.orientation, complex.wrong-neighbor.
// Requires: the verdict is about the mesh, which fails; its points have dimension 2 or 3, and that is
// the dimension of their affine hull.
std::optional<Refutation> refutation_of(const ExactMesh& mesh, const Verdict& verdict,
                                        const ScaledPoints& points);

// As proofs/CERTIFICATE.md lays it out.
void write(std::ostream& out, const ExactMesh& mesh, const ScaledPoints& points,
           const Refutation& refutation);

}  // namespace circumspect::certificate
