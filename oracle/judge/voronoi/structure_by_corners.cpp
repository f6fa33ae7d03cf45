#include "oracle/judge/voronoi/structure_by_corners.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/complex/polytope.hpp"

namespace circumspect::check {
namespace {

using definition::VoronoiStructure;

std::map<Point, Simplex> vertices_of_cells(const PointSet& sites,
                                           const std::vector<std::vector<Point>>& cells) {
  std::map<Point, Simplex> vertices;
  for (Vertex site = 0; sites.names(site); ++site) {
    for (const Point& corner : cells[static_cast<std::size_t>(site)]) {
      vertices[corner].push_back(site);
    }
  }
  std::erase_if(vertices, [&](const auto& vertex) {
    std::vector<Point> nearest;
    for (const Vertex site : vertex.second) nearest.push_back(sites[site]);
    return affine_hull(nearest).dimension < static_cast<int>(sites.ambient_dimension());
  });
  return vertices;
}

}  // namespace

VoronoiStructure structure_by_corners(const PointSet& sites,
                                      const std::vector<std::vector<Point>>& cells) {
  VoronoiStructure structure{.vertices = vertices_of_cells(sites, cells)};
  std::map<Face, std::size_t> ends;             // how many vertices each edge of the diagram has
  std::map<Face, std::set<Face>> around_ridge;  // its edges; in the plane itself
  for (const auto& [centre, nearest] : structure.vertices) {
    std::set<Face> ridges;
    for (const Face& facet : facets_by_wrapping(sites, nearest)) {
      ++ends[facet];
      const bool is_ridge = sites.ambient_dimension() == 2;
      const std::vector<Face> of_facet =
          is_ridge ? std::vector<Face>{facet} : facets_by_wrapping(sites, facet);
      for (const Face& ridge : of_facet) {
        ridges.insert(ridge);
        around_ridge[ridge].insert(facet);
      }
    }
    for (const Face& ridge : ridges) {
      structure.ridges[{ridge[0], ridge[1]}].ends.push_back(centre);
    }
  }
  for (auto& [pair, ridge] : structure.ridges) {
    const std::set<Face>& edges = around_ridge.at({pair[0], pair[1]});
    ridge.leaves_box = std::any_of(edges.begin(), edges.end(),
                                   [&](const Face& edge) { return ends.at(edge) == 1; });
  }
  return structure;
}

}  // namespace circumspect::check
