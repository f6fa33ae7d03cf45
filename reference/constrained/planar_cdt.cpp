#include "reference/constrained/planar_cdt.hpp"

#include <algorithm>
#include <cassert>
#include <set>

#include "reference/complex/flat.hpp"
#include "reference/complex/star_index.hpp"
#include "reference/complex/unfinished_facets.hpp"
#include "reference/constrained/carve.hpp"
#include "reference/constrained/clear_apex.hpp"
#include "reference/constrained/obstacles.hpp"
#include "reference/constrained/planar_domain.hpp"
#include "reference/constrained/segment_insertion.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect::constrained {
namespace {

Simplex counterclockwise(const PointSet& points, const Polygon& polygon, Simplex triangle) {
  if (orientation(points.configuration(), polygon.axes, triangle) < 0) {
    std::swap(triangle[0], triangle[1]);
  }
  return triangle;
}

// The segments, each oriented so that the polygon is in front; both ways if it is on both sides. The
// polygon's own triangles, which have all its segments for edges, tell.
UnfinishedFacets sides_within(const PointSet& points, const Polygon& polygon) {
  const std::set<Simplex> segments(polygon.segments.begin(), polygon.segments.end());
  UnfinishedFacets sides;
  for (const Simplex& triangle : polygon.triangles) {
    const Simplex oriented = counterclockwise(points, polygon, triangle);
    for (std::size_t place = 0; place < 3; ++place) {
      const OrientedFacet side = OrientedFacet::opposite(oriented, place);
      if (segments.contains(side.vertices)) sides.add(side);
    }
  }
  return sides;
}

std::vector<Simplex> ascending(std::vector<Simplex> triangles) {
  for (Simplex& triangle : triangles) triangle = sorted(std::move(triangle));
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// Every part of the polygon is bounded by segments, so all of it is reached.
std::vector<Simplex> by_gift_wrapping(const PointSet& points, const Polygon& polygon) {
  const Obstacles obstacles(points, polygon.axes, polygon.segments);
  const auto is_clear = [&](const Simplex& triangle) { return obstacles.is_clear(triangle); };
  UnfinishedFacets unfinished = sides_within(points, polygon);
  SimplexDictionary dictionary;
  while (!unfinished.empty()) {
    const OrientedFacet edge = unfinished.first();
    const std::optional<Vertex> apex =
        first_clear_apex(points, polygon.axes, edge, polygon.vertices, is_clear).apex;
    assert(apex);  // In the plane there always is a CDT.
    const Simplex triangle = join(edge, *apex);
    dictionary.add(triangle);
    unfinished.adjoin(triangle);
  }
  return ascending(dictionary.simplices());
}

// Those triangles that are joined to the inner side of a segment, across edges that are none.
std::vector<Simplex> part_within(const PointSet& points, const Polygon& polygon,
                                 const StarIndex& triangles) {
  const std::set<Simplex> segments(polygon.segments.begin(), polygon.segments.end());
  SimplexDictionary dictionary;
  for (const Simplex& triangle : triangles.simplices()) {
    dictionary.add(counterclockwise(points, polygon, triangle));
  }
  std::vector<OrientedFacet> pending = sides_within(points, polygon).all();
  std::set<Simplex> within;
  while (!pending.empty()) {
    const OrientedFacet edge = pending.back();
    pending.pop_back();
    const Simplex triangle = join(edge, dictionary.adjacent(edge).value());
    if (!within.insert(sorted(triangle)).second) continue;
    for (std::size_t place = 0; place < 3; ++place) {
      const OrientedFacet side = OrientedFacet::opposite(triangle, place);
      if (!segments.contains(side.vertices)) pending.push_back(side.reverse());
    }
  }
  return {within.begin(), within.end()};
}

std::vector<Simplex> by_segment_insertion(const PointSet& points, const Polygon& polygon) {
  StarIndex triangles = planar_delaunay(points, polygon.axes, polygon.vertices);
  for (const Simplex& segment : polygon.segments) {
    insert_segment(points, polygon.axes, triangles, segment);
  }
  return part_within(points, polygon, triangles);
}

}  // namespace

std::vector<Simplex> planar_cdt(const PointSet& points, const Polygon& polygon,
                                PlanarAlgorithm algorithm) {
  return algorithm == PlanarAlgorithm::kGiftWrapping ? by_gift_wrapping(points, polygon)
                                                     : by_segment_insertion(points, polygon);
}

PlcTriangulation planar_cdt(const PiecewiseLinearComplex& complex, PlanarAlgorithm algorithm) {
  const Polygon domain = planar_domain(complex.points, {0, 1}, all_vertices(complex.points),
                                       complex.segments, complex.hole_seeds, complex.kind);
  std::set<Simplex> faces(complex.segments.begin(), complex.segments.end());
  for (const Vertex v : domain.vertices) faces.insert({v});
  return with_dangling(planar_cdt(complex.points, domain, algorithm), faces);
}

}  // namespace circumspect::constrained
