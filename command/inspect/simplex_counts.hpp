// How many simplices the canonical Delaunay triangulation has, and how many it could have.
// Book: Section 4.1 ("a triangulation of n vertices in R³ has at most …").
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/complex/triangulation.hpp"

namespace circumspect::cli {

struct SimplexCount {
  int dimension;
  std::size_t count;
  // What no triangulation of as many points exceeds; known for three-dimensional sets.
  std::optional<std::size_t> bound;
};

// One entry for each dimension from 1 to that of the triangulation of `points` points; of simplices
// that have too many faces to list them (20,000,000, in high dimensions) only that of the last.
std::vector<SimplexCount> simplex_counts(const Triangulation& triangulation, std::size_t points);

}  // namespace circumspect::cli
