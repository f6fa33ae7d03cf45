// What can be demanded of a hull, beside the claim `convex-hull`.
#pragma once

#include <optional>
#include <string>

#include "oracle/judge/points/check.hpp"

namespace CLI {
class App;
}

namespace circumspect::cli {

void add_hull_options(CLI::App& command, HullDemands& demands);

// What is demanded, into `check`; what is wrong with it, empty if all is well.
std::string settle_hull_options(const HullDemands& demands, std::optional<Claim> claim,
                                check::Options& check);

}  // namespace circumspect::cli
