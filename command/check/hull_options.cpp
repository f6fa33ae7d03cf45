#include "command/check/hull_options.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace circumspect::cli {

void add_hull_options(CLI::App& command, HullDemands& demands) {
  command.add_flag("--all-boundary-points", demands.all_boundary_points,
                   "With the claim convex-hull: demand that every point in the boundary of the "
                   "hull is a vertex");
  command.add_flag("--only-extreme", demands.only_extreme,
                   "With the claim convex-hull: demand that every vertex is an extreme point");
}

std::string settle_hull_options(const HullDemands& demands, std::optional<Claim> claim,
                                check::Options& check) {
  check.hull = demands;
  if (claim == Claim::kConvexHull || !(demands.all_boundary_points || demands.only_extreme)) {
    return "";
  }
  return fmt::format("expected --claim convex-hull beside {}, found {}",
                     demands.all_boundary_points ? "--all-boundary-points" : "--only-extreme",
                     claim ? name(*claim) : "none");
}

}  // namespace circumspect::cli
