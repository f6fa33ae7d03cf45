#include "command/inspect/domain_facts.hpp"

#include <algorithm>
#include <utility>

#include "reference/kernel/piecewise_linear/regions.hpp"

namespace circumspect::cli {
namespace {

void count_regions(const Regions& regions, DomainFacts& facts) {
  for (std::size_t region = 0; region < regions.size(); ++region) {
    if (region == Regions::kUnbounded) continue;
    if (regions.where(region) == Where::kInside) ++facts.polyhedra;
    if (regions.where(region) == Where::kHole) ++facts.holes;
  }
  facts.ignored_hole_seeds = regions.ignored_seeds();
}

void look_for_cdt(const PiecewiseLinearComplex& complex, const Regions& regions,
                  const SearchLimits& limits, DomainFacts& facts) {
  if (complex.ambient_dimension() == 2) {
    facts.cdt = CdtAnswer::kCanonical;
    return;
  }
  CdtDecision decision = decide_cdt(complex, regions, limits);
  facts.cdt = decision.answer;
  facts.no_cdt = std::move(decision.refutation);
  if (decision.cdt) return;
  existence::Existence any =
      existence::any_triangulation(complex, regions, existence_limits(limits));
  if (std::holds_alternative<existence::Exists>(any)) facts.triangulation = true;
  if (auto* impossible = std::get_if<existence::Impossible>(&any)) {
    facts.triangulation = false;
    facts.no_triangulation = std::move(*impossible);
  }
}

}  // namespace

DomainFacts facts_of(const LoadedDomain& loaded, const SearchLimits& limits) {
  const PiecewiseLinearComplex& complex = loaded.domain.complex;
  const Regions regions(complex);
  DomainFacts facts;
  count_regions(regions, facts);
  facts.adoptions = adoptions(loaded.file.input, complex);
  facts.segments = constrained::edge_protection(complex);
  facts.is_edge_protected = constrained::is_edge_protected(complex);
  facts.is_edge_protected_under_perturbation =
      facts.is_edge_protected || constrained::is_edge_protected_under_perturbation(complex);
  look_for_cdt(complex, regions, limits, facts);
  return facts;
}

}  // namespace circumspect::cli
