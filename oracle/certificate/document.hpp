// A verdict with what proves it to somebody who trusts neither this program nor the one that made the
// mesh.
#pragma once

#include <ostream>
#include <string>
#include <variant>

#include <tl/expected.hpp>

#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/refutation.hpp"

namespace circumspect::certificate {

struct RefutationWithPoints {
  Refutation refutation;
  ScaledPoints points;
};

using Document = std::variant<Certificate, RefutationWithPoints>;

// A certificate if the claim holds of the mesh, else a refutation. Error: why there is none, for
// people: other claims; points that span no plane or space, or have other dimensions; a verdict that
// fails for nothing but rules that are no part of the claim.
tl::expected<Document, std::string> document_of(const ExactMesh& mesh, const Verdict& verdict);

void write(std::ostream& out, const ExactMesh& mesh, const Document& document);

}  // namespace circumspect::certificate
