#include "kernel/predicates/perturbation.hpp"

#include <algorithm>
#include <vector>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect {
int perturbed_in_ball(const Configuration& points, std::span<const std::size_t> axes,
                      std::span<const Vertex> simplex, Vertex q) {
  if (const int side = in_ball(points, axes, simplex, q); side != 0) return side;
  std::vector<std::size_t> places(simplex.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  std::sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    return points.rank(simplex[a]) < points.rank(simplex[b]);
  });
  for (const std::size_t place : places) {
    if (points.rank(q) < points.rank(simplex[place])) return 1;
    const int coordinate = barycentric_sign(points, axes, simplex, place, q);
    if (coordinate != 0) return -coordinate;
  }
  return 1;
}

int perturbed_in_ball(const Configuration& points, std::span<const Vertex> simplex, Vertex q) {
  return perturbed_in_ball(points, points.axes(), simplex, q);
}

int perturbed_in_outer_halfspace(const Configuration& points, std::span<const Vertex> facet,
                                 int outward, Vertex q) {
  const int side = side_of_facet(points, facet, q);
  if (side != 0) return side == outward ? 1 : -1;
  return perturbed_in_ball(points, axes_of(points, facet), facet, q);
}

}  // namespace circumspect
