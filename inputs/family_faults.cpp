#include "inputs/family_faults.hpp"

#include <vector>

namespace circumspect::generators {

std::string dimensions_text(const Family& family) {
  constexpr std::size_t kLargest = 16;  // of the table
  std::vector<std::size_t> found;
  for (std::size_t dimension = 1; dimension <= kLargest; ++dimension) {
    if (family.exists_in(dimension)) found.push_back(dimension);
  }
  const std::string first = std::to_string(found.front());
  if (found.size() == 1) return first;
  if (found.back() == kLargest) return first + " and above";
  return first + " to " + std::to_string(found.back());
}

std::string unknown_family_text(std::string_view kind, std::string_view found,
                                std::string_view nearest) {
  std::string text = "expected the name of a family";
  if (!kind.empty()) text.append(" of ").append(kind);
  text.append(", found '").append(found).append("'").append(nearest);
  return text + "; `circumspect generate --list` shows all";
}

std::string no_sets_text(std::string_view family, std::string_view dimensions, std::int64_t found) {
  std::string text(family);
  text.append(" exists in dimension ").append(dimensions);
  return text + "; expected such a dimension, found " + std::to_string(found);
}

}  // namespace circumspect::generators
