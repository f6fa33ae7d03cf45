#include "properties/faulty/point_arrays.hpp"

#include <numeric>
#include <set>

#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::faulty {
namespace {

std::vector<Point> exact_coordinates(const PointArray& points) {
  std::vector<Point> exact(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      exact[i].push_back(exact_value(points.point(i)[axis]));
    }
  }
  return exact;
}

}  // namespace

PointSet exact_points(const PointArray& points) {
  std::vector<Rational> weights;
  for (const double weight : points.weights) weights.push_back(exact_value(weight));
  return PointSet(exact_coordinates(points), std::move(weights));
}

SimplexArray right_answer(const PointArray& points) {
  const std::vector<Point> all = exact_coordinates(points);
  std::set<Point> seen;
  std::vector<Vertex> first;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (seen.insert(all[i]).second) first.push_back(static_cast<Vertex>(i));
  }
  const Triangulation canonical = delaunay::bowyer_watson(exact_points(selection(points, first)));
  SimplexArray simplices;
  for (const Simplex& simplex : canonical.simplices()) {
    simplices.emplace_back(simplex.begin(), simplex.end());
  }
  return renumbered(std::move(simplices), first);
}

PointArray selection(const PointArray& points, const std::vector<Vertex>& kept) {
  PointArray some{points.dimension};
  for (const Vertex v : kept) {
    const auto i = static_cast<std::size_t>(v);
    some.coordinates.insert(some.coordinates.end(), points.point(i),
                            points.point(i) + points.dimension);
    if (!points.weights.empty()) some.weights.push_back(points.weights[i]);
  }
  return some;
}

SimplexArray renumbered(SimplexArray simplices, const std::vector<Vertex>& kept) {
  for (auto& simplex : simplices) {
    for (auto& v : simplex) v = kept[static_cast<std::size_t>(v)];
  }
  return simplices;
}

std::vector<Vertex> every_index(const PointArray& points) {
  std::vector<Vertex> all(points.size());
  std::iota(all.begin(), all.end(), Vertex{0});
  return all;
}

}  // namespace circumspect::faulty
