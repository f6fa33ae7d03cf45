#include "reference/constrained/planar_cdt.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <set>
#include <utility>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "reference/constrained/clear_apex.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::constrained {

namespace {

// The chain of the hull that has all vertices on its left or on it, from the first vertex to the
// last in the order given, which is that of the first axis (then of the second).
std::vector<Vertex> hull_chain(const PointSet& points, const std::vector<std::size_t>& axes,
                               const std::vector<Vertex>& in_order) {
  std::vector<Vertex> chain;
  for (const Vertex v : in_order) {
    while (chain.size() >= 2 && orientation(points.configuration(), axes,
                                            Simplex{chain.end()[-2], chain.back(), v}) < 0) {
      chain.pop_back();
    }
    chain.push_back(v);
  }
  return chain;
}

}  // namespace

std::vector<Simplex> hull_edges(const PointSet& points, const std::vector<std::size_t>& axes,
                                std::vector<Vertex> vertices) {
  std::sort(vertices.begin(), vertices.end(), [&](Vertex a, Vertex b) {
    const Point& p = points[a];
    const Point& q = points[b];
    return p[axes[0]] != q[axes[0]] ? p[axes[0]] < q[axes[0]] : p[axes[1]] < q[axes[1]];
  });
  std::vector<Simplex> edges;
  for (int side = 0; side < 2; ++side) {
    const std::vector<Vertex> chain = hull_chain(points, axes, vertices);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      edges.push_back(sorted({chain[i - 1], chain[i]}));
    }
    std::reverse(vertices.begin(), vertices.end());
  }
  keep_each_once(edges);
  return edges;
}

Polygon planar_domain(const PointSet& points, const std::vector<std::size_t>& axes,
                      const std::vector<Vertex>& vertices, std::vector<Simplex> segments,
                      const std::vector<Point>& hole_seeds, DomainKind kind) {
  if (kind == DomainKind::kHull) {
    for (const Simplex& edge : hull_edges(points, axes, vertices)) segments.push_back(edge);
    keep_each_once(segments);
  }
  const bool has_holes = kind == DomainKind::kEnclosed;
  Polygon polygon{vertices, segments, has_holes ? hole_seeds : std::vector<Point>{}, axes, {}};
  polygon.triangles = polygon_triangles(points, axes, vertices, segments, polygon.hole_seeds);
  return polygon;
}

namespace {

// The vertices of a cavity in order along its boundary; an edge with the cavity on both sides is
// passed twice, and so is a vertex where the boundary touches itself.
using Chain = std::vector<Vertex>;

struct Cavities {
  std::vector<Simplex> crossed;
  Chain left, right;  // both from the first end of the segment to the second
};

class SegmentInsertion {
 public:
  SegmentInsertion(const PointSet& points, const std::vector<std::size_t>& axes,
                   const StarIndex& triangles)
      : points_(points), axes_(axes), triangles_(triangles) {}

  // Walks through the triangles that ab crosses.
  Cavities crossed_by(Vertex a, Vertex b) const {
    Cavities cavities{{}, {a}, {a}};
    Simplex edge = crossed_edge_at(a, b, cavities.crossed);
    while (true) {
      const Vertex left = side(a, b, edge[0]) > 0 ? edge[0] : edge[1];
      const Vertex right = left == edge[0] ? edge[1] : edge[0];
      if (cavities.left.back() != left) cavities.left.push_back(left);
      if (cavities.right.back() != right) cavities.right.push_back(right);
      const std::vector<Simplex> adjoining = triangles_.star(edge);
      assert(adjoining.size() == 2);
      const Simplex& next = adjoining[0] == cavities.crossed.back() ? adjoining[1] : adjoining[0];
      cavities.crossed.push_back(next);
      const Vertex apex = without(next, edge).front();
      if (apex == b) break;
      edge = sorted({apex, side(a, b, apex) > 0 ? right : left});
    }
    cavities.left.push_back(b);
    cavities.right.push_back(b);
    return cavities;
  }

  // Fills the cavity on the left of the edge from the chain's front to its back. All vertices of
  // the chain are visible from the edge, through the triangles that were there; so the first of
  // them in the pencil of circles through the edge is the apex of its triangle, which leaves two
  // smaller cavities of the same kind. (They wait in a list: one within the other they may be as
  // many as the chain is long, too many to call this function again for each.)
  void retriangulate(Chain chain, std::vector<Simplex>& created) const {
    std::vector<Chain> pending = {std::move(chain)};
    while (!pending.empty()) {
      const Chain cavity = std::move(pending.back());
      pending.pop_back();
      if (cavity.size() <= 2) continue;
      const std::size_t place = apex_place(cavity);
      created.push_back(sorted({cavity.front(), cavity[place], cavity.back()}));
      const auto middle = cavity.begin() + static_cast<std::ptrdiff_t>(place);
      pending.emplace_back(cavity.begin(), middle + 1);
      pending.emplace_back(middle, cavity.end());
    }
  }

 private:
  int side(Vertex a, Vertex b, Vertex c) const {
    if (a == c || b == c) return 0;
    return orientation(points_.configuration(), axes_, Simplex{a, b, c});
  }

  // The edge opposite a in the triangle that ab enters at a.
  Simplex crossed_edge_at(Vertex a, Vertex b, std::vector<Simplex>& crossed) const {
    for (const Simplex& triangle : triangles_.star({a})) {
      const Simplex edge = without(triangle, {a});
      const int turn = side(a, edge[0], edge[1]);
      if (side(a, edge[0], b) == turn && side(a, b, edge[1]) == turn) {
        crossed.push_back(triangle);
        return edge;
      }
    }
    assert(!"an end of the segment is not a vertex, or a vertex lies inside the segment");
    return {};
  }

  // Where the chain has the apex for the edge from its front to its back. It passes that vertex
  // only once: what it passes between two visits of a vertex u is visible from the edge between two
  // points from which u is, so it lies in the triangle of u and the edge, and comes before u in the
  // pencil.
  std::size_t apex_place(const Chain& chain) const {
    const Vertex a = chain.front(), b = chain.back();
    std::optional<Vertex> apex;
    for (const Vertex v : chain) {
      if (side(a, b, v) <= 0 || v == apex) continue;
      const bool is_first =
          !apex || perturbed_in_ball(points_.configuration(), axes_, Simplex{a, b, *apex}, v) > 0;
      if (is_first) apex = v;
    }
    assert(apex && std::count(chain.begin(), chain.end(), *apex) == 1);
    return static_cast<std::size_t>(std::find(chain.begin(), chain.end(), *apex) - chain.begin());
  }

  const PointSet& points_;
  const std::vector<std::size_t>& axes_;
  const StarIndex& triangles_;
};

// The canonical Delaunay triangulation of some coplanar vertices; empty if they lie on one line.
StarIndex planar_delaunay(const PointSet& points, const std::vector<std::size_t>& axes,
                          const std::vector<Vertex>& vertices) {
  const std::vector<Simplex> hull = hull_edges(points, axes, vertices);
  if (hull.empty()) return StarIndex({});
  UnfinishedFacets unfinished;
  unfinished.add(OrientedFacet::of(hull.front()));
  unfinished.add(OrientedFacet::of(hull.front()).reverse());
  std::vector<Simplex> triangles = delaunay::gift_wrap(points, axes, unfinished, vertices);
  for (Simplex& triangle : triangles) triangle = sorted(std::move(triangle));
  return StarIndex(triangles);
}

// Adds one more segment to the canonical CDT of some segments: deletes the triangles that the
// segment crosses, and retriangulates the cavities on its left and right. Requires: the triangles
// fill a convex hull; both ends are vertices; no vertex is inside the segment, and no other segment
// crosses it.
void insert_segment(const PointSet& points, const std::vector<std::size_t>& axes,
                    StarIndex& triangles, const Simplex& segment) {
  if (triangles.size() == 0 || !triangles.star(segment).empty()) return;
  const SegmentInsertion insertion(points, axes, triangles);
  const Cavities cavities = insertion.crossed_by(segment[0], segment[1]);
  std::vector<Simplex> created;
  insertion.retriangulate(cavities.left, created);
  insertion.retriangulate(Chain(cavities.right.rbegin(), cavities.right.rend()), created);
  triangles.replace(cavities.crossed, created);
}

Simplex counterclockwise(const PointSet& points, const Polygon& polygon, Simplex triangle) {
  if (orientation(points.configuration(), polygon.axes, triangle) < 0) {
    std::swap(triangle[0], triangle[1]);
  }
  return triangle;
}

// The segments, each oriented so that the polygon is in front; both ways if it is on both sides.
// The polygon's own triangles, which have all its segments for edges, tell.
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

// The triangles that are joined to the inner side of a segment across edges that are not segments.
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
