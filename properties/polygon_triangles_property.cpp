// The plane sweep that cuts polygons into triangles: on any points and segments it makes a
// triangulation of their convex hull that has the segments for edges.
#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::properties {
namespace {

using generators::below;

Rational twice_area(const PointSet& points, const std::vector<std::size_t>& axes, Vertex a,
                    Vertex b, Vertex c) {
  return orientation_determinant(points.configuration(), axes, Simplex{a, b, c});
}

// Twice the area of the convex hull: every hull edge has all vertices on its left or in its line.
Rational twice_hull_area(const PointSet& points, const std::vector<std::size_t>& axes) {
  Rational area = 0;
  const std::vector<Vertex> all = all_vertices(points);
  for (const Vertex a : all) {
    for (const Vertex b : all) {
      const bool is_edge =
          a != b && std::all_of(all.begin(), all.end(), [&](Vertex v) {
            if (v == a || v == b) return true;
            const int side = orientation(points.configuration(), axes, Simplex{a, b, v});
            return side > 0 ||
                   (side == 0 && !lies_inside_segment(points.configuration(), std::array{a, b}, v));
          });
      // Around vertex 0, which may be on the hull; of a row of vertices only neighbours count.
      if (is_edge && a != 0 && b != 0) area += twice_area(points, axes, 0, a, b);
    }
  }
  return area;
}

// Different points of the plane z = x + 2y over a grid: coordinates on any two axes will do.
std::vector<Point> slanted_points(long side, std::size_t count) {
  std::set<Point> points;
  for (std::size_t tries = 0; tries < count; ++tries) {
    const Rational x = *below(side), y = *below(side);
    points.insert({x, y, x + 2 * y});
  }
  std::vector<Point> result(points.begin(), points.end());
  for (std::size_t i = result.size(); i > 1; --i) {
    std::swap(result[i - 1], result[static_cast<std::size_t>(*below(static_cast<long>(i)))]);
  }
  return result;
}

std::set<Simplex> some_segments(const PointSet& points, long count) {
  const Configuration& configuration = points.configuration();
  std::set<Simplex> segments;
  const auto size = static_cast<long>(points.size());
  for (; count > 0; --count) {
    const Simplex segment = sorted({*below(size), *below(size)});
    bool fits = segment[0] != segment[1];
    for (const Vertex v : all_vertices(points)) {
      fits = fits && (contains(segment, v) || !lies_inside_segment(configuration, segment, v));
    }
    for (const Simplex& other : segments) {
      const bool touch = contains(other, segment[0]) || contains(other, segment[1]);
      fits = fits && (touch || !segments_cross(configuration, segment, other));
    }
    if (fits) segments.insert(segment);
  }
  return segments;
}

TEST_CASE("triangulate_by_sweep: fills the hull, keeps the segments, face to face") {
  for (const std::vector<std::size_t>& axes : {std::vector<std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    CAPTURE(axes[0] + axes[1]);
    CHECK(holds("points of a slanted plane", 300, [&] {
      const long side = *below(5) + 2;
      const PointSet points(slanted_points(side, static_cast<std::size_t>(*below(14)) + 3));
      const std::set<Simplex> segments = some_segments(points, *below(30));
      const auto triangles = triangulate_by_sweep(points, axes, all_vertices(points),
                                                  {segments.begin(), segments.end()});
      if (points.dimension() < 2) {
        RC_ASSERT(triangles.empty());
        return;
      }
      Rational area = 0;
      std::set<Vertex> corners;
      std::set<Simplex> edges;
      for (const Simplex& t : triangles) {
        const Rational twice = abs(twice_area(points, axes, t[0], t[1], t[2]));
        RC_ASSERT(sign(twice) > 0);
        area += twice;
        corners.insert(t.begin(), t.end());
        for (std::size_t i = 0; i < 3; ++i) edges.insert(facet_opposite(t, i));
        for (const Simplex& other : triangles) {
          const bool same = &other == &t;
          RC_ASSERT(same || !interiors_meet(points.configuration(), axes, t, other));
        }
      }
      // Disjoint, as large as the hull, and with no vertex inside an edge.
      RC_ASSERT(area == twice_hull_area(points, axes));
      RC_ASSERT(corners.size() == points.size());
      RC_ASSERT(std::is_sorted(triangles.begin(), triangles.end()));
      for (const Simplex& segment : segments) RC_ASSERT(edges.contains(segment));
      for (const Simplex& edge : edges) {
        for (const Vertex v : corners) {
          const bool is_end = contains(edge, v);
          RC_ASSERT(is_end || !lies_inside_segment(points.configuration(), edge, v));
        }
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
