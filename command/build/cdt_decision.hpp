// Whether a domain in space has a constrained Delaunay triangulation without Steiner points, and
// which. `inspect` prints the answer, and `build cdt` writes the triangulation. Book: Sections 4.5
// and 5.6.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "command/output/output.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constructions.hpp"
#include "reference/existence/existence.hpp"

namespace circumspect::cli {

// The canonical one is what the symbolic perturbation chooses; where that has none, cocircular or
// cospherical vertices may still allow another.
enum class CdtAnswer { kCanonical, kAnother, kNone, kUnknown };
std::string_view word(CdtAnswer answer);

struct SearchLimits {
  std::size_t vertices = 60;
  int conflicts = 1'000'000;
  // Gift-wrapping is tried in domains of at most so many vertices; 0: in any.
  std::size_t wrapped_vertices = 0;
};

struct CdtDecision {
  CdtAnswer answer = CdtAnswer::kUnknown;
  std::optional<constrained::PlcTriangulation> cdt = {};  // kCanonical, kAnother
  // How it shows that there is no canonical one; nothing if there is, or if that was not decided.
  std::optional<constrained::NoCdt> not_canonical = {};
  std::optional<existence::Impossible> refutation = {};  // kNone
  std::string limit = {};                                // kUnknown: what stopped the search
};

// Gift-wrapping decides about the canonical one, if the insertion of polygons has not found it
// before (`insert`: in domains of more than reference::kFewVertices vertices that is tried first);
// then a search that is exponential at worst, and so has limits, about any. `name`: how
// messages about progress call the domain. Requires: the complex is in space, and valid.
CdtDecision decide_cdt(const PiecewiseLinearComplex& complex, const SearchLimits& limits,
                       bool insert, const std::string& name, Output& output);

// How long gift-wrapping takes, about, on a machine of 2023: from a ball of 1,200 vertices with
// bumps, a double cone of 1,000 and prisms.
double seconds_of_gift_wrapping(std::size_t vertices);

// The limits of any search for a triangulation.
existence::Limits existence_limits(const SearchLimits& limits);

// --search-vertices, --search-conflicts.
void add_search_options(CLI::App& command, SearchLimits& limits);

}  // namespace circumspect::cli
