// What is known of a piecewise linear complex. Book: Sections 4.5 and 5.6.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/build/cdt_decision.hpp"
#include "command/input/domain_input.hpp"
#include "command/output/output.hpp"
#include "construct/edge_protection.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::cli {

struct DomainFacts {
  // Enclosed by polygons (in the plane: by segments); what else there is in a hull is not counted.
  std::size_t polyhedra = 0;
  std::size_t holes = 0;
  std::vector<std::size_t> ignored_hole_seeds = {};  // by their places in the list
  std::vector<Adoption> adoptions = {};
  std::vector<construct::SegmentFacts> segments = {};
  bool is_edge_protected = false;
  bool is_edge_protected_under_perturbation = false;
  CdtAnswer cdt = CdtAnswer::kUnknown;
  std::string limit = {};  // what left that open
  // Is there any triangulation, where there is no CDT? Unknown: not within the limits.
  std::optional<bool> triangulation = {};
  // Where there is none: the proofs.
  std::optional<existence::Impossible> no_cdt = {};
  std::optional<existence::Impossible> no_triangulation = {};
};

// Each finds some of the facts; `output` is told what is being done.
void find_regions(const LoadedDomain& loaded, DomainFacts& facts, Output& output);
construct::EdgeProtection protection_of(const LoadedDomain& loaded, Output& output);
void find_edge_protection(const LoadedDomain& loaded, const construct::EdgeProtection& protection,
                          DomainFacts& facts, Output& output);
void find_cdt(const LoadedDomain& loaded, const construct::EdgeProtection& protection,
              const SearchLimits& limits, DomainFacts& facts, Output& output);

}  // namespace circumspect::cli
