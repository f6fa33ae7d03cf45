// Judges what is required of the shape of each simplex, beside a claim. docs/theory/quality.md is
// the definition.
#pragma once

#include <string>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Why the requirements make no sense of this mesh; one line, empty if they do. `domain`: that of
// the claim, if there is one; `is_moved`: up to a distance.
std::string fault_of_quality(const Mesh& mesh, const QualityDemands& demands, const Domain* domain,
                             bool is_moved);

// Adds a violation for every simplex and requirement that it does not keep, and says what was
// required. Simplices that are set apart (of another dimension, flat, or with an index that names
// no point) break other rules, and none of these. `domain`: that of the claim, if there is one; its
// cells may have been moved by the root of `squared_reach`. Nothing changes if nothing is required.
// Requires: no fault_of_quality.
void judge_quality(const Mesh& mesh, const Domain* domain, const Rational& squared_reach,
                   const Options& options, Verdict& verdict);

}  // namespace circumspect::check
