// The same answer from the room of definitions: its images of cells as the patches and carriers of
// this folder.
#include "oracle/judge/within/reach_by_definition.hpp"

#include <utility>

#include "oracle/judge/definition/simplicial_complex.hpp"
#include "oracle/judge/definition/within.hpp"

namespace circumspect::check {
namespace {

definition::MovedDomain moved_domain(const ExactMesh& mesh, const std::vector<bool>& used,
                                     const Cells& cells, const Regions& regions) {
  definition::MovedDomain moved{cells.complex(), regions, mesh, used, {}};
  moved.triangles_meant.resize(cells.complex().polygons.size());
  for (const Simplex& triangle : faces_of(mesh.simplices_and_faces(), 3)) {
    for (std::size_t p = 0; p < moved.triangles_meant.size(); ++p) {
      if (cells.is_marked(triangle, p)) moved.triangles_meant[p].push_back(triangle);
    }
  }
  return moved;
}

// The first triangle of a polygon, counterclockwise as those of its image are.
Simplex own_triangle(const PiecewiseLinearComplex& complex, std::size_t polygon) {
  Simplex t = complex.polygons[polygon].triangles.front();
  const std::vector<Point> at = coordinates(complex.points, t);
  if (cross_product(at[1] - at[0], at[2] - at[0]) < Point(3, 0)) std::swap(t[1], t[2]);
  return t;
}

ReachAnswer found(const definition::LeastReach& reach, const PiecewiseLinearComplex& complex) {
  ReachAnswer answer{.kind = ReachAnswer::Kind::kFound, .squared_reach = reach.squared_reach};
  for (const auto& [cell, simplices] : reach.images) {
    if (cell.dimension == 0) answer.images.vertices.push_back(simplices.front().front());
    if (cell.dimension == 1) {
      std::vector<Vertex>& path = answer.images.paths.emplace_back();
      for (const Simplex& edge : simplices) path.push_back(edge[0]);
      path.push_back(simplices.back()[1]);
    }
    if (cell.dimension == 2) {
      const std::vector<Simplex> own(simplices.size(), own_triangle(complex, cell.place));
      answer.images.patches.push_back({simplices, own});
    }
  }
  for (const auto& carrier : reach.carriers) {
    answer.carriers.emplace_back();
    answer.carriers.back().cell = carrier;
  }
  answer.moved.assign(reach.carriers.size(), true);
  return answer;
}

}  // namespace

ReachAnswer least_reach_by_definition(const ExactMesh& mesh, const std::vector<bool>& used,
                                      const Cells& cells, const Regions& regions,
                                      const Rational& squared_limit) {
  const auto reach =
      definition::least_reach(moved_domain(mesh, used, cells, regions), squared_limit);
  if (reach) return found(*reach, cells.complex());
  ReachAnswer answer{.kind = ReachAnswer::Kind::kAmbiguous, .squared_reach = squared_limit};
  if (reach.error()) {
    answer.kind = ReachAnswer::Kind::kNone;
    answer.breaches = {*reach.error()};
  }
  return answer;
}

bool is_small_enough_for_definition(const ExactMesh& mesh, const std::vector<bool>& used,
                                    const Cells& cells, const Rational& squared_limit,
                                    std::size_t most) {
  const Regions regions(cells.complex());
  return definition::most_triangles_near(moved_domain(mesh, used, cells, regions), squared_limit) <=
         most;
}

}  // namespace circumspect::check
