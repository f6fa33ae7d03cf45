#include "oracle/judge/quality/exact_measure.hpp"

#include <algorithm>
#include <cassert>

namespace circumspect::quality {
namespace {

template <std::size_t kDimension>
SquaredLengths<kDimension, Rational> lengths_of(const std::vector<Point>& corners) {
  SquaredLengths<kDimension, Rational> lengths;
  for (std::size_t i = 0; i < kDimension; ++i) {
    for (std::size_t j = i + 1; j <= kDimension; ++j) {
      lengths.squared[lengths.place(i, j)] = circumspect::squared_distance(corners[i], corners[j]);
    }
  }
  return lengths;
}

template <std::size_t kDimension>
std::optional<Found> extreme(Measure measure, const std::vector<Point>& corners) {
  const auto lengths = lengths_of<kDimension>(corners);
  if (sign(Rational(spread(lengths))) == 0) return std::nullopt;
  std::optional<Found> worst;
  each_value(measure, lengths, [&](const Place& place, const Quotient<Rational>& quotient) {
    const Rational value = quotient.above / quotient.below;
    if (!worst || is_worse(measure, value, worst->value)) worst = Found{value, place};
  });
  return worst;
}

std::optional<Found> extreme_of(Measure measure, const std::vector<Point>& corners) {
  switch (corners.size()) {
    case 2:
      return extreme<1>(measure, corners);
    case 3:
      return extreme<2>(measure, corners);
    case 4:
      return extreme<3>(measure, corners);
    default:
      return std::nullopt;
  }
}

}  // namespace

int dimension_of_simplices(const Mesh& mesh) {
  std::size_t most = mesh.simplices.columns();
  for (std::size_t i = 0; most == 0 && i < mesh.simplices.size(); ++i) {
    most = std::max(most, mesh.simplices[i].size());
  }
  return static_cast<int>(most) - 1;
}

std::optional<Found> measured(Measure measure, const Mesh& mesh, const Simplex& simplex,
                              int dimension) {
  if (static_cast<int>(simplex.size()) != dimension + 1) return std::nullopt;
  std::vector<Point> corners;
  for (const Vertex v : simplex) {
    if (!mesh.names(v)) return std::nullopt;
    corners.push_back(mesh.point(v));
  }
  return extreme_of(measure, corners);
}

Found measured(Measure measure, const std::vector<Point>& corners) {
  auto found = extreme_of(measure, corners);
  assert(found);
  return *std::move(found);
}

Witness witness_of(Measure measure, const Found& found, const Simplex& simplex, std::size_t place) {
  Witness witness{.simplices = {simplex}, .places = {place}};
  Simplex there;
  for (std::size_t i = 0; i < found.place.size; ++i) {
    there.push_back(simplex[found.place.vertices[i]]);
  }
  if (there.size() == 3) witness.vertices = {there.front()};  // the corner
  const bool is_whole = there.empty() || there.size() == simplex.size();
  if (!is_whole) witness.face = sorted(there);
  witness.values = {{entry(measure).is_angle ? "sign(cos) cos²" : "square", found.value}};
  return witness;
}

}  // namespace circumspect::quality
