#include "properties/arguments/laws.hpp"

#include <numeric>
#include <utility>

#include "properties/arguments/generated.hpp"

namespace circumspect::generators {

Configuration configuration(const PointsCase& set, Scaling scaling) {
  if (scaling == Scaling::kCommon || set.points.empty()) {
    return Configuration(set.points, set.weights);
  }
  PointsCase more = set;
  Rational coordinate(1, 3);
  while (bit_length(coordinate.get_den()) <= Configuration::kLargestCommonScale) {
    coordinate *= coordinate;
  }
  more.points.push_back(Point(set.points.front().size(), coordinate));
  if (!set.weights.empty()) more.weights.push_back(0);
  Configuration points(more.points, more.weights);
  RC_ASSERT(!points.has_common_denominator());
  return points;
}

std::vector<Vertex> first_vertices(std::size_t count) {
  std::vector<Vertex> vertices(count);
  std::iota(vertices.begin(), vertices.end(), Vertex{0});
  return vertices;
}

std::vector<Vertex> shuffled(std::vector<Vertex> vertices) {
  for (std::size_t i = vertices.size(); i-- > 1;) {
    const long j = *below(static_cast<long>(i) + 1);
    std::swap(vertices[i], vertices[i - static_cast<std::size_t>(j)]);
  }
  return vertices;
}

Scene scene(const PointsCase& set, Scaling scaling) {
  const AffineHull hull = affine_hull(set.points);
  const auto k = static_cast<std::size_t>(hull.dimension);
  const std::vector<Vertex> vertices = first_vertices(set.points.size());
  const auto first_query = vertices.begin() + static_cast<Vertex>(k + 1);
  return {configuration(set, scaling),
          hull.axes,
          {vertices.begin(), first_query},
          {first_query, vertices.end()}};
}

PointsCase scaled_and_moved(const PointsCase& set, const Rational& factor,
                            const Point& translation) {
  PointsCase image = set;
  for (Point& point : image.points) point = factor * point + translation;
  for (Rational& weight : image.weights) weight *= factor * factor;
  return image;
}

}  // namespace circumspect::generators
