#include "oracle/judge/voronoi/listed_cell.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "oracle/judge/definition/voronoi.hpp"
#include "oracle/judge/voronoi/clipped_cell.hpp"

namespace circumspect::check {
namespace {

using definition::Halfspace;

bool is_inside(const JudgedBox& box, const Point& point) {
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    if (point[axis] < box.low[axis] || point[axis] > box.high[axis]) return false;
  }
  return true;
}

Point with(const Point& point, const Rational& last) {
  Point longer = point;
  longer.push_back(last);
  return longer;
}

// Halfspaces whose common part is the convex hull of the points plus the cone of the directions.
std::vector<Halfspace> halfspaces_around(const std::set<Point>& points,
                                         const std::vector<Point>& directions) {
  const std::size_t d = points.begin()->size();
  Rational most = 1;  // of |n · p|
  for (const Point& point : points) {
    Rational sum = 1;
    for (const Rational& x : point) sum += abs(x);
    most = std::max(most, sum);
  }
  ClippedCell pairs({with(Point(d, -1), -most), with(Point(d, 1), most)});
  for (const Point& point : points) pairs.cut({with(point, -1), 0});
  for (const Point& direction : directions) pairs.cut({with(direction, 0), 0});
  std::vector<Halfspace> halves;
  for (const Point& pair : pairs.corners()) {
    Halfspace half{{pair.begin(), pair.end() - 1}, pair.back()};
    if (sign(squared_length(half.normal)) != 0) halves.push_back(std::move(half));
  }
  return halves;
}

// As definition::directions_of: of the listed neighbours first, then of the sites to which one of
// the directions found so far comes nearer.
std::vector<Point> directions_of(const VoronoiDiagram& diagram, Vertex site) {
  if (!diagram.cells[static_cast<std::size_t>(site)].is_unbounded) return {};
  const PointSet& sites = diagram.sites;
  std::set<Vertex> others;
  for (const auto& [a, b] : diagram.neighbors) {
    if (a == site) others.insert(b);
    if (b == site) others.insert(a);
  }
  others.erase(site);
  while (true) {
    std::vector<Point> normals;
    for (const Vertex other : others) normals.push_back(sites[other] - sites[site]);
    std::vector<Point> directions =
        definition::spanning_directions(normals, sites.ambient_dimension());
    const std::size_t before = others.size();
    for (const Point& direction : directions) {
      std::optional<Vertex> nearest;
      Rational most = 0;
      for (Vertex other = 0; sites.names(other); ++other) {
        const Rational along = inner_product(sites[other] - sites[site], direction);
        if (along <= most) continue;
        most = along;
        nearest = other;
      }
      if (nearest) others.insert(*nearest);
    }
    if (others.size() == before) return directions;
  }
}

}  // namespace

std::vector<Point> corners_of_listed(const VoronoiDiagram& diagram, Vertex site,
                                     const JudgedBox& box) {
  std::set<Point> points;
  for (const Vertex v : diagram.cells[static_cast<std::size_t>(site)].corners) {
    points.insert(diagram.vertices[static_cast<std::size_t>(v)]);
  }
  if (points.empty()) return {};
  const std::vector<Point> directions = directions_of(diagram, site);
  const auto is_in_box = [&box](const Point& point) { return is_inside(box, point); };
  if (directions.empty() && std::all_of(points.begin(), points.end(), is_in_box)) {
    return {points.begin(), points.end()};
  }
  ClippedCell cell(box);
  for (const Halfspace& half : halfspaces_around(points, directions)) cell.cut(half);
  return cell.corners();
}

}  // namespace circumspect::check
