// `inspect` of a domain: is it a piecewise linear complex, what are its parts, and does it have a CDT?
// Book: Sections 4.5 and 5.6.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/build/cdt_decision.hpp"
#include "command/input/domain_input.hpp"
#include "command/input/input.hpp"
#include "command/output/output.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/picture/page.hpp"
#include "reference/constrained/edge_protection.hpp"

namespace circumspect::cli {

struct DomainInspection {
  bool is_asked_for = false;  // whatever the name of the file says
  DomainOptions said = {};
  bool all_segments = false;  // name every segment, not only those that are not strongly Delaunay
  std::size_t max_errors = kBreachLimit;  // how many breaches are reported; 0: all
  SearchLimits limits = {.wrapped_vertices = reference::kFewVertices};
  bool decide = false;           // is an open question a failure?
  std::string refutations = {};  // where proofs go that there is no triangulation; empty: nowhere
};

// --domain, those of add_domain_options, --all-segments, --max-errors, --decide, --search-vertices,
// --search-conflicts, --refutations.
void add_domain_inspection_options(CLI::App& command, DomainInspection& options);

// The facts that --only may name: in the order in which they are found, and printed at once.
std::vector<std::string> domain_facts();

// `only`: some of the facts; none means all. Requires: domain_facts() has them. What is found is added to `page`, if
// there is one.
void inspect_domain(const std::string& path, const InputOptions& input,
                    const DomainInspection& options, const std::vector<std::string>& only,
                    Output& output, picture::Page* page);

// ---- Facts ----
// What is known of a piecewise linear complex. Book: Sections 4.5 and 5.6.

struct DomainFacts {
  // Enclosed by polygons (in the plane: by segments); what else there is in a hull is not counted.
  std::size_t polyhedra = 0;
  std::size_t holes = 0;
  std::vector<std::size_t> ignored_hole_seeds = {};  // by their places in the list
  std::vector<Adoption> adoptions = {};
  std::vector<constrained::SegmentProtection> segments = {};
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
void find_edge_protection(const LoadedDomain& loaded, DomainFacts& facts, Output& output);
void find_cdt(const LoadedDomain& loaded, const SearchLimits& limits, DomainFacts& facts,
              Output& output);

// ---- Proofs as files ----
// Proofs that a domain has no triangulation, as files.

// The files that write_refutations may write.
std::vector<std::string> refutation_files(const std::string& prefix);

// Writes PREFIX-cdt.cnf and .drat if it is proved that there is no CDT, and PREFIX-triangulation.cnf
// and .drat if there is no triangulation at all. A formula says in comments which tetrahedron each
// variable is. Returns an error message, or an empty string.
std::string write_refutations(const std::string& prefix, const Domain& domain,
                              const DomainFacts& facts);

}  // namespace circumspect::cli
