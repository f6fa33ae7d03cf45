// Proof that a claim does not hold; and a verdict together with its proof, whichever way it went.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/complex_certificate.hpp"
#include "oracle/certificate/flat_certificate.hpp"
#include "oracle/certificate/hull_certificate.hpp"
#include "oracle/certificate/line_certificate.hpp"
#include "oracle/certificate/scaled_points.hpp"
#include "oracle/certificate/surface_certificate.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

// What proves that a claim does not hold of a mesh: one fault, with the evidence by which it can be
// seen. proofs/CERTIFICATE.md says which evidence each rule takes.

struct Refutation {
  Claim claim;
  Rule rule;
  std::vector<Integer> because;    // the tokens of the evidence
  std::vector<std::size_t> basis;  // points that span the affine hull of all
};

// Of the rules that the verdict says are broken the first that can be shown. Linear in the mesh.
// Nothing if all that is broken is not part of the claim: simplex.orientation,
// complex.wrong-neighbor.
// Requires: the verdict is about the mesh, which fails; its points have dimension 2 or 3, and that
// is the dimension of their affine hull, or smaller (flat_refutation.cpp).
std::optional<Refutation> refutation_of(const ExactMesh& mesh, const Verdict& verdict,
                                        const ScaledPoints& points);

// As proofs/CERTIFICATE.md lays it out.
void write(std::ostream& out, const ExactMesh& mesh, const ScaledPoints& points,
           const Refutation& refutation);
// Its parts: the points and simplices, where the first line ends with the rule or, instead of it,
// with `words`; the simplices alone; the line `spans`; and the line `because`, with the end.
void write_mesh(Lines& lines, const ExactMesh& mesh, const ScaledPoints& points,
                const Refutation& refutation, std::string_view words = "");
void write_simplices(Lines& lines, const std::vector<Simplex>& simplices);
void write_basis(Lines& lines, const std::vector<std::size_t>& basis);
void write_because(Lines& lines, const std::vector<Integer>& because);

// A verdict with what proves it to somebody who trusts neither this program nor the one that made
// the mesh.

struct RefutationWithPoints {
  Refutation refutation;
  ScaledPoints points;
};

using Document = std::variant<Certificate, ComplexCertificate, HullCertificate, FlatCertificate,
                              LineCertificate, SurfaceCertificate, RefutationWithPoints>;

// Claims of which nothing is proved.
bool is_unproved(Claim claim);

// A certificate if the claim holds of the mesh, else a refutation. Error: why there is none, for
// people: other claims; points of other dimensions, or that span no plane or space (but for the
// claims complex, if it holds, surface-delaunay, triangulation and delaunay); a verdict that fails
// for nothing but rules that are not part of the claim, or that there is no refutation of.
tl::expected<Document, std::string> document_of(const ExactMesh& mesh, const Verdict& verdict);

void write(std::ostream& out, const ExactMesh& mesh, const Document& document);

}  // namespace circumspect::certificate
