#include "oracle/certificate/evidence.hpp"

namespace circumspect::certificate {

std::optional<Evidence> overlap_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule, const Witness& witness) {
  if (!witness.point || witness.simplices.size() != 2) return std::nullopt;
  Evidence evidence{rule, {}};
  for (const Simplex& simplex : witness.simplices) {
    evidence.because.emplace_back(static_cast<unsigned long>(number_of(mesh, simplex)));
  }
  const HomogeneousPoint common = scaled(points, *witness.point);
  evidence.because.insert(evidence.because.end(), common.numerators.begin(),
                          common.numerators.end());
  evidence.because.push_back(common.denominator);
  return evidence;
}

}  // namespace circumspect::certificate
