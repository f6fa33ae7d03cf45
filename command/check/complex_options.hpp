// What can be demanded of a mesh alone, beside the claim `complex`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/model/claim.hpp"
#include "oracle/model/options.hpp"

namespace CLI {
class App;
}

namespace circumspect::cli {

struct ComplexOptions {
  ComplexDemands demands;
  std::string oriented = {};              // "same", "positive", "negative"; empty: not asked
  std::vector<std::string> allowed = {};  // --allow
};

void add_complex_options(CLI::App& command, ComplexOptions& options);
// The only one of them that certificates cover.
void add_allow_unused_option(CLI::App& command, bool& allow_unused);

// The first option that asks something of the claim `complex` alone; empty if none does.
std::string of_complexes_alone(const ComplexOptions& options);

// What the options demand of the claim, into `check`; what is wrong with them, empty if all is
// well.
std::string settle_complex_options(const ComplexOptions& options, std::optional<Claim> claim,
                                   check::Options& check);

}  // namespace circumspect::cli
