// Integers back in a type of the language.
#pragma once

#include <cstdint>
#include <optional>

#include "kernel/exact/number.hpp"

namespace circumspect {

// Nothing of an integer that needs more than 64 bits. (GMP's own conversions end at `long`, which
// does not have 64 bits on every machine.)
std::optional<std::int64_t> to_int64(const Integer& value);

}  // namespace circumspect
