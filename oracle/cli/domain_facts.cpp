#include "oracle/cli/domain_facts.hpp"

#include <algorithm>
#include <utility>

#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/piecewise_linear/regions.hpp"

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

// Gift-wrapping decides about the canonical one; a search that is exponential at worst, about any.
void look_for_cdt(const PiecewiseLinearComplex& complex, const Regions& regions,
                  const SearchLimits& limits, DomainFacts& facts) {
  const bool in_plane = complex.ambient_dimension() == 2;
  if (in_plane || constrained::gift_wrapping_cdt(complex)) {
    facts.cdt = CdtAnswer::kCanonical;
    return;
  }
  const existence::Limits within{.vertices = limits.vertices, .conflicts = limits.conflicts};
  existence::Existence cdt = existence::any_cdt(complex, regions, within);
  if (std::holds_alternative<existence::Exists>(cdt)) facts.cdt = CdtAnswer::kAnother;
  if (facts.cdt == CdtAnswer::kAnother) return;
  if (auto* impossible = std::get_if<existence::Impossible>(&cdt)) {
    facts.cdt = CdtAnswer::kNone;
    facts.no_cdt = std::move(*impossible);
  }
  existence::Existence any = existence::any_triangulation(complex, regions, within);
  if (std::holds_alternative<existence::Exists>(any)) facts.triangulation = true;
  if (auto* impossible = std::get_if<existence::Impossible>(&any)) {
    facts.triangulation = false;
    facts.no_triangulation = std::move(*impossible);
  }
}

}  // namespace

std::string_view word(CdtAnswer answer) {
  switch (answer) {
    case CdtAnswer::kCanonical:
      return "canonical";
    case CdtAnswer::kAnother:
      return "another";
    case CdtAnswer::kNone:
      return "none";
    case CdtAnswer::kUnknown:
      return "unknown";
  }
  return "";
}

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
