// Numbers on a line, as all text formats write them.
#pragma once

#include <string>
#include <vector>

#include "reference/kernel/exact/point.hpp"
#include "reference/kernel/predicates/configuration.hpp"

namespace circumspect::formats {

// With blanks between them; numbers so that reading them as doubles gives the same ones.
std::string joined(const std::vector<Rational>& numbers);
std::string joined(const std::vector<Vertex>& indices);

}  // namespace circumspect::formats
