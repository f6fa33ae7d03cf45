#include "command/check/quality_options.hpp"

#include <CLI/CLI.hpp>

namespace circumspect::cli {

void add_quality_options(CLI::App& command, QualityDemands& demands) {
  const auto read = [&demands](const CLI::results_t& texts) {
    demands.requirements.clear();
    for (const std::string& text : texts) {
      const auto requirement = read_requirement(text);
      if (!requirement) throw CLI::ValidationError("--require", requirement.error());
      demands.requirements.push_back(*requirement);
    }
    return true;
  };
  command
      .add_option(
          "--require", read,
          "Also demand this of every simplex, such as min-angle:20.7deg (or, quoted, "
          "'min-angle >= 20.7deg'): at least so much of min-angle, min-dihedral, min-edge; "
          "at most so much of max-angle, max-dihedral, radius-edge, aspect-ratio, volume, "
          "area, edge. area:regions and volume:regions: what the .poly file of --domain allows in "
          "each region. May be given several times")
      ->expected(1, -1)
      ->option_text("MEASURE:BOUND");
  const auto read_sharp = [&demands](const CLI::results_t& texts) {
    const auto degrees = read_degrees(texts.front());
    if (!degrees) throw CLI::ValidationError("--except-sharp", degrees.error());
    demands.except_sharp = *degrees;
    return true;
  };
  command
      .add_option("--except-sharp", read_sharp,
                  "Of --require, set aside and count the simplices that touch both sides of an "
                  "angle of less than this between segments or polygons of the domain (without a "
                  "domain, of the boundary of the mesh): 60deg")
      ->option_text("ANGLE");
}

std::string quality_fault(const QualityDemands& demands) {
  if (demands.empty() && demands.except_sharp) {
    return "expected --require MEASURE:BOUND beside --except-sharp, found none";
  }
  return contradiction(demands.requirements);
}

}  // namespace circumspect::cli
