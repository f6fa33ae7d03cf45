// Claims by their names.
#pragma once

#include <string>

#include "oracle/model/verdict.hpp"

namespace circumspect::arrays {

// One of the claims that need no domain. Throws std::invalid_argument for any other name.
Claim claim_named(const std::string& claim);

}  // namespace circumspect::arrays
