// The axes of space, where a test is asked of them by number.
#pragma once

#include <array>
#include <cstddef>

namespace circumspect {

inline constexpr std::array<std::size_t, 3> kSpace = {0, 1, 2};

}  // namespace circumspect
