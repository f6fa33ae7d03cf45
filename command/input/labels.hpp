// The numbers that the vertices of a domain have in its file.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "oracle/model/domain.hpp"

namespace circumspect::cli {

// Requires: vertices of the domain.
inline std::string labels(const Domain& domain, const Simplex& simplex) {
  std::vector<Vertex> own;
  for (const Vertex v : simplex) own.push_back(domain.label(v));
  return fmt::format("{}", fmt::join(own, " "));
}

}  // namespace circumspect::cli
