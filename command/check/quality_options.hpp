// --require and --except-sharp: what is demanded of the shape of simplices beside a claim.
#pragma once

#include <string>

#include "oracle/model/measure.hpp"

namespace CLI {
class App;
}

namespace circumspect::cli {

void add_quality_options(CLI::App& command, QualityDemands& demands);

// What is wrong with the demands together; empty if all is well.
std::string quality_fault(const QualityDemands& demands);

}  // namespace circumspect::cli
