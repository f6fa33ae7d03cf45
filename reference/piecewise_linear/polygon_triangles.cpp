#include "reference/piecewise_linear/polygon_triangles.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "reference/complex/facets.hpp"
#include "reference/exact/box_index.hpp"
#include "reference/piecewise_linear/triangulate_by_sweep.hpp"
#include "reference/predicates/intersection.hpp"

namespace circumspect {
namespace {

Point projection(const Point& point, const std::vector<std::size_t>& axes) {
  return {point[axes[0]], point[axes[1]]};
}

// The triangles that hold a seed.
std::vector<std::size_t> triangles_at(const std::vector<Point>& seeds, const PointSet& points,
                                      const std::vector<std::size_t>& axes,
                                      const std::vector<Simplex>& triangles) {
  if (seeds.empty()) return {};
  std::vector<std::vector<Point>> corners;
  std::vector<Box> boxes;
  for (const Simplex& triangle : triangles) {
    std::vector<Point> projections;
    for (const Vertex v : triangle) projections.push_back(projection(points[v], axes));
    boxes.push_back(box_around(box_around(box_around(projections[0]), box_around(projections[1])),
                               box_around(projections[2])));
    corners.push_back(std::move(projections));
  }
  const BoxIndex index(boxes);
  std::vector<std::size_t> found;
  for (const Point& seed : seeds) {
    const Point at = projection(seed, axes);
    for (const std::size_t i : index.meeting(box_around(at))) {
      if (!intersection(corners[i], {at}).empty()) found.push_back(i);
    }
  }
  return found;
}

// Marks triangles, and what is joined to them across edges that are no walls.
class Flood {
 public:
  Flood(const std::vector<Simplex>& triangles, const std::vector<Simplex>& walls)
      : triangles_(triangles), walls_(walls.begin(), walls.end()), reached_(triangles.size()) {
    for (const FacetUse& use : facet_uses(triangles)) at_edge_[use.facet].push_back(use.simplex);
  }

  void from_outside() {
    for (const auto& [edge, uses] : at_edge_) {
      if (uses.size() == 1 && !walls_.contains(edge)) from(uses.front());
    }
  }
  void from(std::size_t start) {
    std::vector<std::size_t> pending;
    reach(start, pending);
    while (!pending.empty()) {
      const Simplex& triangle = triangles_[pending.back()];
      pending.pop_back();
      for (std::size_t place = 0; place < 3; ++place) {
        const Simplex edge = sorted(facet_opposite(triangle, place));
        if (walls_.contains(edge)) continue;
        for (const std::size_t neighbour : at_edge_[edge]) reach(neighbour, pending);
      }
    }
  }
  bool has_reached(std::size_t triangle) const { return reached_[triangle]; }

 private:
  void reach(std::size_t triangle, std::vector<std::size_t>& pending) {
    if (reached_[triangle]) return;
    reached_[triangle] = true;
    pending.push_back(triangle);
  }

  const std::vector<Simplex>& triangles_;
  std::set<Simplex> walls_;
  std::map<Simplex, std::vector<std::size_t>> at_edge_;
  std::vector<bool> reached_;
};

}  // namespace

std::vector<Simplex> polygon_triangles(const PointSet& points, const std::vector<std::size_t>& axes,
                                       const std::vector<Vertex>& vertices,
                                       const std::vector<Simplex>& segments,
                                       const std::vector<Point>& hole_seeds,
                                       const std::vector<Simplex>& slits) {
  std::vector<Simplex> edges = segments;
  edges.insert(edges.end(), slits.begin(), slits.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const std::vector<Simplex> triangles = triangulate_by_sweep(points, axes, vertices, edges);
  Flood flood(triangles, segments);
  flood.from_outside();
  for (const std::size_t i : triangles_at(hole_seeds, points, axes, triangles)) flood.from(i);
  std::vector<Simplex> inside;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!flood.has_reached(i)) inside.push_back(triangles[i]);
  }
  return inside;
}

}  // namespace circumspect
