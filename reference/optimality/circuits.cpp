#include "reference/optimality/circuits.hpp"

#include <optional>

#include "reference/complex/subsets.hpp"
#include "reference/optimality/barycentric.hpp"

namespace circumspect::optimality {
namespace {

// The last point in barycentric coordinates of the others, if it has such and none is zero.
std::optional<Circuit> circuit_of(const PointSet& points, const Simplex& subset) {
  const Simplex others(subset.begin(), subset.end() - 1);
  const auto coefficients = barycentric_coordinates(points, others, points[subset.back()]);
  if (!coefficients) return std::nullopt;
  Circuit circuit;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const int side = sign((*coefficients)[i]);
    if (side == 0) return std::nullopt;
    (side > 0 ? circuit.positive : circuit.negative).push_back(others[i]);
  }
  circuit.negative.push_back(subset.back());
  return circuit;
}

}  // namespace

std::vector<Circuit> circuits(const PointSet& points) {
  std::vector<Circuit> all;
  const auto largest = static_cast<std::size_t>(points.dimension() + 2);
  for (std::size_t size = 3; size <= largest && size <= points.size(); ++size) {
    Simplex subset = first_subset(size);
    do {
      if (const auto circuit = circuit_of(points, subset)) all.push_back(*circuit);
    } while (next_subset(subset, points.size()));
  }
  return all;
}

}  // namespace circumspect::optimality
