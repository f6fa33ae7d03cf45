#include "oracle/judge/points/difference.hpp"

#include <map>
#include <utility>

namespace circumspect::check {
namespace {

using WeightedPoint = std::pair<Point, Rational>;

std::map<WeightedPoint, Vertex> places(const PointSet& points) {
  std::map<WeightedPoint, Vertex> places;
  for (Vertex v = 0; points.names(v); ++v)
    places.emplace(WeightedPoint(points[v], points.weight(v)), v);
  return places;
}

// The points of `mesh` that `others` lacks, and for each point its place there (−1: it has none).
std::vector<Vertex> matched(const PointSet& points, const std::map<WeightedPoint, Vertex>& others,
                            std::vector<Vertex>& only_here) {
  std::vector<Vertex> places;
  for (Vertex v = 0; points.names(v); ++v) {
    const auto other = others.find({points[v], points.weight(v)});
    places.push_back(other == others.end() ? -1 : other->second);
    if (other == others.end()) only_here.push_back(v);
  }
  return places;
}

}  // namespace

Cells cells_of(const ExactMesh& mesh) {
  Cells cells;
  for (const Simplex& simplex : mesh.simplices) cells.add(simplex);
  add_dangling(cells, mesh.faces, mesh.points.size());
  return cells;
}

Difference difference(const ExactMesh& a, const ExactMesh& b) {
  Difference result;
  const auto in_b = matched(a.points, places(b.points), result.points_only_in_a);
  matched(b.points, places(a.points), result.points_only_in_b);
  CellDifference cells = difference_of_cells(cells_of(a), cells_of(b), in_b, b.points.size());
  result.simplices_only_in_a = std::move(cells.only_in_a);
  result.simplices_only_in_b = std::move(cells.only_in_b);
  return result;
}

}  // namespace circumspect::check
