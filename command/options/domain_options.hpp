// The options that describe a domain beside its file: what it fills, and which of its polygons are
// joined.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "oracle/domain/filling.hpp"
#include "oracle/model/claim.hpp"

namespace circumspect::cli {

struct DomainOptions {
  std::optional<Fill> fill = {};
  std::vector<Point> holes = {};    // more hole seeds
  std::vector<Point> regions = {};  // if any, nothing is filled but what they are in
  bool resolves = false;  // --resolve: the domain is the arrangement of what the file lists
  // --merge-coplanar: the tangent of the angle, 0 if polygons have to be in one plane exactly.
  std::optional<Rational> merged_slope = {};

  bool is_given() const {
    return fill || !holes.empty() || !regions.empty() || resolves || merged_slope.has_value();
  }
  bool merges_bent() const { return merged_slope && *merged_slope > 0; }
};

// The slope of one degree, as --merge-coplanar counts angles.
const Rational& slope_of_degree();

// Adds --fill (or --domain-kind), --hole, --region, --resolve and --merge-coplanar. `takes_angle`:
// may the last one have an angle, which only a command with --within can make something of?
void add_domain_options(CLI::App& command, DomainOptions& options, bool takes_angle = false);

// What options contradict each other; empty if none do.
std::string domain_options_fault(const DomainOptions& options);
// The same beside a claim, if one was asked for, and a domain that is given or not.
std::string domain_options_fault(const DomainOptions& options, std::optional<Claim> claim,
                                 bool has_domain);

// Makes one word of --merge-coplanar and an angle behind it, which CLI11 would take for a file:
// whether a value follows an option, it decides without looking at it. A number without a unit is
// meant as an angle, too, and is then refused. Words behind -- stay as they are.
std::vector<std::string> with_angles_joined(int argc, char** argv);

}  // namespace circumspect::cli
