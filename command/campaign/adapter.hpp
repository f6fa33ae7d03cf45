// Programs to begin with for those who let a campaign talk to a worker.
#pragma once

#include <map>
#include <string>

namespace circumspect::cli {

// The texts of fuzz/adapters, by the extensions of their names: ".py".
const std::map<std::string, std::string>& adapters();

}  // namespace circumspect::cli
