#include "oracle/judge/domain/measures.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polytope.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

Axes all_axes(std::size_t dimension) {
  Axes axes(dimension);
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  return axes;
}

// Simplices that fill a polytope: one of its points joined to those that fill the facets off it.
std::vector<Simplex> simplices_of(const PointSet& points, const Face& polytope) {
  if (polytope.size() == 1) return {polytope};
  std::vector<Simplex> simplices;
  const Vertex apex = polytope.front();
  for (const Face& facet : facets_by_definition(points, polytope)) {
    if (std::binary_search(facet.begin(), facet.end(), apex)) continue;
    for (Simplex simplex : simplices_of(points, facet)) {
      simplex.push_back(apex);
      simplices.push_back(simplex);
    }
  }
  return simplices;
}

}  // namespace

Rational measure(const PointSet& points, const Axes& axes, const Simplex& simplex) {
  return abs(orientation_determinant(points.configuration(), axes, simplex));
}

Rational measure(const PointSet& points, const Axes& axes, const std::vector<Simplex>& simplices) {
  Rational sum = 0;
  for (const Simplex& simplex : simplices) sum += measure(points, axes, simplex);
  return sum;
}

Rational common_area(const Axes& axes, const std::vector<Point>& a, const std::vector<Point>& b) {
  const std::vector<Point> corners = intersection(a, b);
  Rational twice = 0;
  for (std::size_t i = 0; corners.size() > 2 && i < corners.size(); ++i) {
    const Point& p = corners[i];
    const Point& q = corners[(i + 1) % corners.size()];
    twice += p[axes[0]] * q[axes[1]] - q[axes[0]] * p[axes[1]];
  }
  return abs(twice);
}

Rational measure_of_inside(const PiecewiseLinearComplex& complex, const Regions& regions) {
  const Axes axes = all_axes(complex.ambient_dimension());
  const auto is_inside = [&](const OrientedFacet& wall) {
    return regions.where(regions.in_front_of(wall)) == Where::kInside;
  };
  // The sum of the signed cones from one point over the sides of walls that face the inside.
  Rational sum = 0;
  for (const Simplex& wall : walls(complex)) {
    const OrientedFacet facet{sorted(wall), false};
    Simplex cone = facet.vertices;
    cone.push_back(0);
    const Rational volume = orientation_determinant(complex.points.configuration(), axes, cone);
    if (is_inside(facet)) sum += volume;
    if (is_inside(facet.reverse())) sum -= volume;
  }
  return sum;
}

Rational measure_of_hull(const PointSet& points) {
  return measure(points, all_axes(points.ambient_dimension()),
                 simplices_of(points, all_vertices(points)));
}

}  // namespace circumspect::check
