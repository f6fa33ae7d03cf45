#include "command/inspect/simplex_counts.hpp"

#include "kernel/complex/simplex.hpp"

namespace circumspect::cli {

namespace {

// Listing more faces of simplices takes gigabytes.
constexpr std::size_t kMostFaces = 20'000'000;

// "At most (n²−3n−2)/2 tetrahedra, at most n²−3n triangles, and at most (n²−n)/2 edges."
std::optional<std::size_t> bound(int dimension_of_set, int dimension, std::size_t n) {
  if (dimension_of_set != 3) return std::nullopt;
  switch (dimension) {
    case 1:
      return (n * n - n) / 2;
    case 2:
      return n * n - 3 * n;
    default:
      return (n * n - 3 * n - 2) / 2;
  }
}

}  // namespace

std::vector<SimplexCount> simplex_counts(const Triangulation& triangulation, std::size_t points) {
  const int k = triangulation.dimension();
  std::vector<SimplexCount> counts;
  const std::size_t simplices = triangulation.simplices().size();
  if (k > 0 && simplices > (kMostFaces >> (k + 1))) {
    counts.push_back({k, simplices, bound(k, k, points)});
    return counts;
  }
  for (int j = 1; j <= k; ++j) {
    const auto corners = static_cast<std::size_t>(j) + 1;
    counts.push_back({j, j == k ? simplices : faces_of(triangulation.simplices(), corners).size(),
                      bound(k, j, points)});
  }
  return counts;
}

}  // namespace circumspect::cli
