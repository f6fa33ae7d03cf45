// Systems of linear equations over the rationals.
#pragma once

#include <optional>
#include <vector>

#include "reference/kernel/exact/number.hpp"

namespace circumspect {

using RationalMatrix = std::vector<std::vector<Rational>>;

// The solution x of A x = b by Gaussian elimination; nothing if A is singular.
// Requires: A is square, b as long as A.
std::optional<std::vector<Rational>> solve(RationalMatrix a, std::vector<Rational> b);

}  // namespace circumspect
