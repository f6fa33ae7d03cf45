// The one place where families of point sets are listed: a new family is a function, and a line here.
#pragma once

#include <vector>

#include "inputs/families.hpp"

namespace circumspect::generators {

std::vector<Family> family_table();

}  // namespace circumspect::generators
