#include "command/inspect/domain_facts.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "kernel/piecewise_linear/regions.hpp"
#include "reference/existence/existence.hpp"

namespace circumspect::cli {

void find_regions(const LoadedDomain& loaded, DomainFacts& facts, Output& output) {
  output.begin("finding the regions of " + loaded.name);
  const Regions regions = loaded.domain.regions();
  for (std::size_t region = 0; region < regions.size(); ++region) {
    if (region == Regions::kUnbounded) continue;
    if (regions.where(region) == Where::kInside) ++facts.polyhedra;
    if (regions.where(region) == Where::kHole) ++facts.holes;
  }
  facts.ignored_hole_seeds = regions.ignored_seeds();
  facts.adoptions = adoptions(loaded.file.input, loaded.domain.complex);
}

construct::EdgeProtection protection_of(const LoadedDomain& loaded, Output& output) {
  output.begin("triangulating the vertices of " + loaded.name);
  return construct::EdgeProtection(loaded.domain.complex, output.progress());
}

void find_edge_protection(const LoadedDomain& loaded, const construct::EdgeProtection& protection,
                          DomainFacts& facts, Output& output) {
  output.begin("deciding whether " + loaded.name + " is edge-protected");
  facts.segments = protection.segments(output.progress());
  facts.is_edge_protected = std::all_of(facts.segments.begin(), facts.segments.end(),
                                        [](const auto& segment) { return segment.is_strong(); });
  facts.is_edge_protected_under_perturbation = protection.holds_under_perturbation();
}

void find_cdt(const LoadedDomain& loaded, const construct::EdgeProtection& protection,
              const SearchLimits& limits, DomainFacts& facts, Output& output) {
  const PiecewiseLinearComplex& complex = loaded.domain.complex;
  // Book: Theorem 4.9. Where a segment is missing, the insertion of polygons does not even begin.
  const bool is_protected =
      complex.points.dimension() == 3 && protection.holds_under_perturbation();
  if (complex.ambient_dimension() == 2 || is_protected) {
    facts.cdt = CdtAnswer::kCanonical;
    return;
  }
  CdtDecision decision = decide_cdt(complex, limits, false, loaded.name, output);
  facts.cdt = decision.answer;
  facts.limit = std::move(decision.limit);
  facts.no_cdt = std::move(decision.refutation);
  if (decision.cdt || complex.points.size() > limits.vertices) return;
  output.begin("searching for a triangulation of " + loaded.name);
  existence::Existence any =
      existence::any_triangulation(complex, Regions(complex), existence_limits(limits));
  if (std::holds_alternative<existence::Exists>(any)) facts.triangulation = true;
  if (auto* impossible = std::get_if<existence::Impossible>(&any)) {
    facts.triangulation = false;
    facts.no_triangulation = std::move(*impossible);
  }
}

}  // namespace circumspect::cli
