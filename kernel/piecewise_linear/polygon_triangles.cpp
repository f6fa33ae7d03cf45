#include "kernel/piecewise_linear/polygon_triangles.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {

namespace {

// A line sweeps over the plane and meets the vertices in lexicographic order of their coordinates
// on the two axes (as if it were vertical, but turned by an infinitesimal angle, so that it meets
// them one by one). The segments that it meets at a time are ordered from bottom to top, and
// between two neighbours, or beyond the last, lies a gap. All triangles that can be drawn between
// the vertices of a gap behind the line are drawn; what is left of the gap, towards the line, is
// bounded by two chains from the ends of its segments (without a segment there: from the first of
// all vertices) to the vertex last met in the gap. Seen from the line every vertex within a chain
// bulges out, or the triangle of it and its neighbours could be drawn.
//
// The next vertex sees the one last met: nothing lies between, for the segments are straight and
// have both between them. So it sees both chains from there on up to some vertex of each, like the
// next point of a Graham scan.
struct Gap {
  // The two chains, from the segments to the vertex last met, in which both end.
  std::vector<Vertex> lower;
  std::vector<Vertex> upper;
};

// A segment that the sweep line meets, and the gap above it.
struct Crossed {
  Vertex left;
  Vertex right;
  std::size_t gap_above;
};

class Sweep {
 public:
  Sweep(const PointSet& points, const std::vector<std::size_t>& axes)
      : points_(points), axes_(axes) {}

  std::vector<Simplex> run(std::vector<Vertex> vertices, const std::vector<Simplex>& segments) {
    std::sort(vertices.begin(), vertices.end(), [&](Vertex a, Vertex b) { return before(a, b); });
    sort_segments(segments);
    for (const Vertex v : vertices) meet(v);
    assert(crossed_.empty());
    std::sort(triangles_.begin(), triangles_.end());
    return std::move(triangles_);
  }

 private:
  bool before(Vertex a, Vertex b) const {
    const Point& p = points_[a];
    const Point& q = points_[b];
    const int first = cmp(p[axes_[0]], q[axes_[0]]);
    return first != 0 ? first < 0 : p[axes_[1]] < q[axes_[1]];
  }
  // Positive if the three turn left.
  int turn(Vertex a, Vertex b, Vertex c) const {
    return orientation(points_.configuration(), axes_, Simplex{a, b, c});
  }

  // The right ends of the segments by their left ends, from bottom to top.
  void sort_segments(const std::vector<Simplex>& segments) {
    for (const Simplex& s : segments) {
      const bool in_order = before(s[0], s[1]);
      right_ends_[in_order ? s[0] : s[1]].push_back(in_order ? s[1] : s[0]);
    }
    for (auto& [left, rights] : right_ends_) {
      std::sort(rights.begin(), rights.end(),
                [&, v = left](Vertex a, Vertex b) { return turn(v, a, b) > 0; });
    }
  }

  std::size_t new_gap(std::vector<Vertex> lower, std::vector<Vertex> upper) {
    gaps_.push_back({std::move(lower), std::move(upper)});
    return gaps_.size() - 1;
  }

  // Joins v to the chain as far as it sees it, last vertex first, and ends the chain in v. The last
  // two vertices of a chain and v turn to `side` where they bulge in.
  void join(std::vector<Vertex>& chain, Vertex v, int side) {
    while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), v) == side) {
      draw(v, chain[chain.size() - 2], chain.back());
      chain.pop_back();
    }
    chain.push_back(v);
  }
  // Joins v, the right end of the segment from which the chain starts, to the whole chain: the
  // chain bulges towards the segment, and v lies strictly beyond the lines of all its edges.
  void join_all(const std::vector<Vertex>& chain, Vertex v) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) draw(v, chain[i], chain[i + 1]);
  }
  void draw(Vertex a, Vertex b, Vertex c) { triangles_.push_back(sorted({a, b, c})); }

  void meet(Vertex v) {
    if (gaps_.empty()) bottom_gap_ = new_gap({}, {});
    // The segments that end in v are adjacent: those below v come before them, those above v after.
    const auto first = std::partition_point(
        crossed_.begin(), crossed_.end(),
        [&](const Crossed& s) { return s.right != v && turn(s.left, s.right, v) > 0; });
    auto last = first;
    while (last != crossed_.end() && last->right == v) ++last;
    const std::size_t below = first == crossed_.begin() ? bottom_gap_ : (first - 1)->gap_above;
    const std::size_t above = last == first ? below : (last - 1)->gap_above;
    for (auto s = first; last - s > 1; ++s) {
      join_all(gaps_[s->gap_above].lower, v);
      join_all(gaps_[s->gap_above].upper, v);
      gaps_[s->gap_above] = {};
    }
    if (below != above) {
      join_all(gaps_[below].upper, v);
      join_all(gaps_[above].lower, v);
    }
    join(gaps_[below].lower, v, -1);
    join(gaps_[above].upper, v, 1);
    replace(first, last, v, below, above);
  }

  // The segments that end in v give way to those that start in it.
  void replace(std::vector<Crossed>::iterator first, std::vector<Crossed>::iterator last, Vertex v,
               std::size_t below, std::size_t above) {
    std::vector<Vertex> upper = std::move(gaps_[above].upper);
    const auto found = right_ends_.find(v);
    if (found == right_ends_.end()) {
      gaps_[below].upper = std::move(upper);
      if (above != below) gaps_[above] = {};
      crossed_.erase(first, last);
      return;
    }
    gaps_[below].upper = {v};
    std::vector<Crossed> starting;
    for (const Vertex right : found->second) starting.push_back({v, right, new_gap({v}, {v})});
    gaps_[starting.back().gap_above].upper = std::move(upper);
    const auto reused = std::min(last - first, static_cast<std::ptrdiff_t>(starting.size()));
    std::copy(starting.begin(), starting.begin() + reused, first);
    if (first + reused != last) {
      crossed_.erase(first + reused, last);
    } else {
      crossed_.insert(last, starting.begin() + reused, starting.end());
    }
  }

  const PointSet& points_;
  const std::vector<std::size_t>& axes_;
  std::unordered_map<Vertex, std::vector<Vertex>> right_ends_;
  std::vector<Crossed> crossed_;  // from bottom to top
  std::vector<Gap> gaps_;         // closed gaps are empty
  std::size_t bottom_gap_ = 0;
  std::vector<Simplex> triangles_;
};

}  // namespace

std::vector<Simplex> triangulate_by_sweep(const PointSet& points,
                                          const std::vector<std::size_t>& axes,
                                          const std::vector<Vertex>& vertices,
                                          const std::vector<Simplex>& segments) {
  return Sweep(points, axes).run(vertices, segments);
}

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
    boxes.push_back(box_around_all(projections));
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

// Marks triangles, and those that are joined to them across edges that are not walls.
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
  keep_each_once(edges);
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
