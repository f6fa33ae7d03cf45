// Facets of one simplex that lie in no wall: why is nothing beyond them?
#pragma once

#include <vector>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/judge/domain/outside_simplices.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// domain.outside: the simplex or the facet is. complex.overlap: vertices of other simplices hang in
// the facet, off its own vertices; the smaller facets in it that lead up to them, whose simplices
// are on its other side, are then no fault of their own. domain.uncovered: anything else.
// At least one violation if there is a loose facet. Requires: matched facets.
void judge_loose_facets(const MeshedDomain& in, const std::vector<FacetUse>& loose,
                        OutsideSimplices& outside, Verdict& verdict);

}  // namespace circumspect::check
