#include "oracle/formats/weights.hpp"

namespace circumspect::formats {

Result<std::vector<Rational>> weights_of(RawPoints& points, Weights which) {
  if (which == Weights::kNone) return {};
  if (which == Weights::kListed || !points.weights.empty() || points.points.points.empty()) {
    return std::move(points.weights);
  }
  std::vector<Rational> first_attributes;
  for (const std::vector<Rational>& attributes : points.points.attributes) {
    if (!attributes.empty()) first_attributes.push_back(attributes.front());
  }
  if (first_attributes.size() == points.points.points.size()) return first_attributes;
  return tl::unexpected(FormatError{
      points.name, 0,
      "a weight for each point (the first attribute of a .node file, the key \"weights\" of JSON)",
      "none"});
}

}  // namespace circumspect::formats
