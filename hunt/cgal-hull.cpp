// convex_hull_2 and convex_hull_3, by a kernel with exact predicates.
#include <map>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>

#include "lines.hpp"

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

lines::Simplices plane(const lines::Points& points) {
  std::map<Kernel::Point_2, int> index;
  std::vector<Kernel::Point_2> all, hull;
  for (const auto& p : points) {
    all.emplace_back(p[0], p[1]);
    index.emplace(all.back(), static_cast<int>(index.size()));
  }
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
  lines::Simplices edges;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    edges.push_back({index.at(hull[i]), index.at(hull[(i + 1) % hull.size()])});
  }
  return edges;
}

lines::Simplices space(const lines::Points& points) {
  std::map<Kernel::Point_3, int> index;
  std::vector<Kernel::Point_3> all;
  for (const auto& p : points) {
    all.emplace_back(p[0], p[1], p[2]);
    index.emplace(all.back(), static_cast<int>(index.size()));
  }
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(all.begin(), all.end(), hull);
  lines::Simplices facets;
  for (const auto face : hull.faces()) {
    facets.emplace_back();
    for (const auto v : vertices_around_face(hull.halfedge(face), hull)) {
      facets.back().push_back(index.at(hull.point(v)));
    }
  }
  return facets;
}

int main() {
  return lines::serve([](const lines::Points& points) {
    return points[0].size() == 2 ? plane(points) : space(points);
  });
}
