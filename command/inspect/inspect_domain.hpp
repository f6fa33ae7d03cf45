// `inspect` of a domain: is it a piecewise linear complex, what are its parts, and does it have a
// CDT? Book: Sections 4.5 and 5.6.
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

// `only`: some of the facts; none means all. Requires: domain_facts() has them. What is found is
// added to `page`, if there is one.
void inspect_domain(const std::string& path, const InputOptions& input,
                    const DomainInspection& options, const std::vector<std::string>& only,
                    Output& output, picture::Page* page);

}  // namespace circumspect::cli
