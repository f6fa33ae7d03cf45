// How long work takes, about, on a machine of 2023: for Output::begin, which says it beforehand if
// nobody waits that long.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::cli {

// How many simplices of the highest dimension a triangulation has at most, less than the Upper
// Bound Theorem allows for its lifted points: about half of the facets of a cyclic polytope. And
// how long it takes to make them, in dimensions in which that is more than a moment.
inline std::optional<double> seconds_of_triangulating(std::size_t points, int dimension) {
  if (dimension < 4) return std::nullopt;
  const auto n = static_cast<double>(points);
  const int half = (dimension + 1) / 2;
  double simplices = 1;
  for (int i = 0; i < half; ++i) simplices *= std::max(1.0, n - half - 1 - i) / (i + 1);
  return simplices * 1e-6 * std::pow(dimension, 3);
}

// By definition, every pair of simplices is looked at, and every simplex with every point. By
// lemma, each facet of each simplex is: in the plane and in space nobody need wait long for that,
// but a determinant of dimension k takes k³ multiplications of numbers that become longer with k.
inline std::optional<double> seconds_of_judging(const Mesh& mesh, const check::Options& options) {
  const auto simplices = static_cast<double>(mesh.simplices.size());
  const auto points = static_cast<double>(mesh.points());
  const auto corners = static_cast<double>(mesh.dimension() + 1);
  if (options.by == check::By::kDefinition) {
    const double than_in_space = std::pow(std::max(1.0, corners / 4), 4);
    return (simplices * simplices / 2 * 2e-5 + simplices * points * 2e-6) * than_in_space;
  }
  if (mesh.dimension() < 4) return std::nullopt;
  return simplices * 4e-7 * std::pow(corners, 4);
}

}  // namespace circumspect::cli
