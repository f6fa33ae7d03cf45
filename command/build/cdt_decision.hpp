// Has a domain in space a constrained Delaunay triangulation without Steiner points, and which?
// `inspect` tells the answer, `build cdt` writes the triangulation. Book: Sections 4.5 and 5.6.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/existence/existence.hpp"

namespace circumspect::cli {

// The canonical one is what the symbolic perturbation chooses; where that has none, cocircular or
// cospherical vertices may still allow another.
enum class CdtAnswer { kCanonical, kAnother, kNone, kUnknown };
std::string_view word(CdtAnswer answer);

struct SearchLimits {
  std::size_t vertices = 60;
  int conflicts = 1'000'000;
};

struct CdtDecision {
  CdtAnswer answer = CdtAnswer::kUnknown;
  std::optional<constrained::PlcTriangulation> cdt = {};  // kCanonical, kAnother
  std::optional<constrained::NoCdt> not_canonical = {};   // all but kCanonical: how that shows
  std::optional<existence::Impossible> refutation = {};   // kNone
  std::string limit = {};                                 // kUnknown: what stopped the search
};

// Gift-wrapping decides about the canonical one; then a search that is exponential at worst, and so
// has limits, about any.
// Requires: the complex is in space, and valid; the regions are its own.
CdtDecision decide_cdt(const PiecewiseLinearComplex& complex, const Regions& regions,
                       const SearchLimits& limits);

// The limits of any search for a triangulation.
existence::Limits existence_limits(const SearchLimits& limits);

// --search-vertices, --search-conflicts.
void add_search_options(CLI::App& command, SearchLimits& limits);

}  // namespace circumspect::cli
