// Numbers with commas between them, as --box and --lattice take them.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect::cli {

// Nothing if one of them is not a number.
inline std::optional<std::vector<Rational>> number_list(const std::string& text) {
  std::vector<Rational> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = read_number(text.substr(begin, end - begin), NumberReading::kDouble);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

}  // namespace circumspect::cli
