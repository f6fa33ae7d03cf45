// Random triangulations of a polygon. Book: Section 4.5.1.
#pragma once

#include <algorithm>
#include <vector>

#include "properties/arguments/numbers.hpp"
#include "reference/kernel/complex/star_index.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::properties {

// Some triangulation of the polygon that has its segments for edges, Delaunay or not, after up to
// five random flips. Within a property or rc::gen::exec.
inline std::vector<Simplex> any_triangulation_of(const PointSet& points, const Polygon& polygon) {
  std::vector<Simplex> triangles = polygon.triangles;
  for (Simplex& triangle : triangles) triangle = sorted(triangle);
  StarIndex index(triangles);
  for (long i = *generators::below(6); i > 0; --i) {
    std::vector<Simplex> edges = facets_of({index.simplices().begin(), index.simplices().end()});
    std::erase_if(edges, [&](const Simplex& edge) {
      if (std::binary_search(polygon.segments.begin(), polygon.segments.end(), edge)) return true;
      const auto star = index.star(edge);
      const Vertex a = without(star[0], edge)[0], b = without(star[1], edge)[0];
      const int at_one_end =
          orientation(points.configuration(), polygon.axes, Simplex{a, b, edge[0]});
      const int at_other =
          orientation(points.configuration(), polygon.axes, Simplex{a, b, edge[1]});
      return at_one_end * at_other >= 0;
    });
    if (edges.empty()) break;
    const Simplex edge =
        edges[static_cast<std::size_t>(*generators::below(static_cast<long>(edges.size())))];
    const auto star = index.star(edge);
    const Simplex apexes = join(without(star[0], edge), without(star[1], edge));
    index.replace(star, {join(apexes, {edge[0]}), join(apexes, {edge[1]})});
  }
  return {index.simplices().begin(), index.simplices().end()};
}

}  // namespace circumspect::properties
