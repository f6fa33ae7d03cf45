#include "oracle/domain/coplanar_polygons.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <set>
#include <span>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect {
namespace {

bool lie_in_one_plane(const Configuration& points, const Polygon& a, const Polygon& b) {
  const Simplex& other = b.triangles.front();
  return std::all_of(other.begin(), other.end(), [&](Vertex v) {
    return contains(a.triangles.front(), v) ||
           side_of_triangle(points, a.triangles.front(), v) == 0;
  });
}

// An edge of a triangle, and on which side of it the triangle lies in its plane.
using EdgeSide = std::pair<Simplex, int>;

std::vector<EdgeSide> edge_sides(const Configuration& points, const std::vector<std::size_t>& axes,
                                 const Simplex& triangle) {
  std::vector<EdgeSide> sides;
  for (std::size_t place = 0; place < 3; ++place) {
    const Simplex edge = facet_opposite(triangle, place);
    sides.emplace_back(edge, orientation(points, axes, Simplex{edge[0], edge[1], triangle[place]}));
  }
  return sides;
}

// Joins triangles across edges that are not among some, and says which set each is in.
DisjointSets joined_across(const std::vector<Simplex>& triangles, const std::set<Simplex>& barred) {
  DisjointSets sets(triangles.size());
  for (const auto at_edge : ByFacet(facet_uses(triangles))) {
    if (at_edge.size() != 2 || barred.contains(at_edge.front().facet)) continue;
    sets.unite(at_edge[0].simplex, at_edge[1].simplex);
  }
  return sets;
}

// A point in each hole of a polygon, of which `triangles` is some triangulation. The convex hull is
// triangulated with all segments of the members as edges. What their segments part lies in a member
// or in none; it lies in one if it is on the side of one of these segments on which a triangle of
// the polygon is. What lies in none, and from which no way leads out but across segments, is a
// hole. `members`: the segments of all members. Requires: ascending triangles and segments.
std::vector<Point> seeds_in_holes(const PointSet& points, const Polygon& polygon,
                                  const std::set<Simplex>& members) {
  const std::vector<Simplex> hull = triangulate_by_sweep(points, polygon.axes, polygon.vertices,
                                                         {members.begin(), members.end()});
  const Configuration& configuration = points.configuration();
  std::set<EdgeSide> covered_sides;
  for (const Simplex& triangle : polygon.triangles) {
    for (EdgeSide& side : edge_sides(configuration, polygon.axes, triangle)) {
      if (members.contains(side.first)) covered_sides.insert(std::move(side));
    }
  }
  DisjointSets parts = joined_across(hull, members);
  std::vector<bool> is_covered(hull.size(), false);
  for (std::size_t t = 0; t < hull.size(); ++t) {
    for (const EdgeSide& side : edge_sides(configuration, polygon.axes, hull[t])) {
      if (covered_sides.contains(side)) is_covered[parts.find(t)] = true;
    }
  }
  std::vector<Simplex> bare;
  for (std::size_t t = 0; t < hull.size(); ++t) {
    if (!is_covered[parts.find(t)]) bare.push_back(hull[t]);
  }
  const std::set<Simplex> kept(polygon.segments.begin(), polygon.segments.end());
  DisjointSets holes = joined_across(bare, kept);
  std::vector<bool> is_open(bare.size(), false);
  std::map<Simplex, std::size_t> uses;
  for (const FacetUse& use : facet_uses(hull)) ++uses[use.facet];
  for (const FacetUse& use : facet_uses(bare)) {
    if (uses[use.facet] == 1 && !kept.contains(use.facet)) is_open[holes.find(use.simplex)] = true;
  }
  std::vector<Point> seeds;
  for (std::size_t t = 0; t < bare.size(); ++t) {
    if (holes.find(t) == t && !is_open[t]) seeds.push_back(barycentre(points, bare[t]));
  }
  return seeds;
}

// That a polygon has a segment.
struct SegmentUse {
  std::array<Vertex, 2> ends;  // ascending
  std::size_t polygon;

  friend auto operator<=>(const SegmentUse&, const SegmentUse&) = default;
};

// By segments, and then by polygons.
std::vector<SegmentUse> segment_uses(const PiecewiseLinearComplex& complex) {
  std::vector<SegmentUse> uses;
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    for (const Simplex& segment : complex.polygons[p].segments) {
      uses.push_back({{segment[0], segment[1]}, p});
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

// Calls visit(uses) for each segment, until it returns false. Did it never?
bool all_segments(std::span<const SegmentUse> uses, const auto& visit) {
  while (!uses.empty()) {
    std::size_t size = 1;
    while (size < uses.size() && uses[size].ends == uses[0].ends) ++size;
    if (!visit(uses.first(size))) return false;
    uses = uses.subspan(size);
  }
  return true;
}

// Calls visit(p, q) for each two polygons of one plane that have a segment, until it returns false.
// Did it never?
bool all_in_one_plane(const PiecewiseLinearComplex& complex, std::span<const SegmentUse> uses,
                      const auto& visit) {
  for (std::size_t i = 0; i < uses.size(); ++i) {
    for (std::size_t j = i + 1; j < uses.size(); ++j) {
      const std::size_t p = uses[i].polygon, q = uses[j].polygon;
      const bool are_in_one = lie_in_one_plane(complex.points.configuration(), complex.polygons[p],
                                               complex.polygons[q]);
      if (are_in_one && !visit(p, q)) return false;
    }
  }
  return true;
}

class JoiningOfPolygons {
 public:
  JoiningOfPolygons(const PiecewiseLinearInput& input, const PiecewiseLinearComplex& complex)
      : input_(input),
        complex_(complex),
        groups_(complex.polygons.size()),
        uses_(segment_uses(complex)) {}

  JoinedPolygons result() {
    all_segments(uses_, [this](std::span<const SegmentUse> at_one) {
      return all_in_one_plane(complex_, at_one, [this](std::size_t p, std::size_t q) {
        groups_.unite(p, q);
        return true;
      });
    });
    const std::vector<Simplex> listed = listed_segments(input_);
    std::set<Simplex> removed;
    all_segments(uses_, [&](std::span<const SegmentUse> at_one) {
      if (at_one.size() != 2) return true;
      if (groups_.find(at_one[0].polygon) != groups_.find(at_one[1].polygon)) return true;
      const Simplex segment(at_one[0].ends.begin(), at_one[0].ends.end());
      const bool is_listed = std::binary_search(listed.begin(), listed.end(), segment);
      if (!is_listed) removed.insert(segment);
      return true;
    });
    std::map<std::size_t, std::size_t> place;  // of each group
    JoinedPolygons joined{input_, complex_, {}, removed.size()};
    for (std::size_t p = 0; p < complex_.polygons.size(); ++p) {
      const auto [at, is_new] = place.try_emplace(groups_.find(p), joined.members.size());
      if (is_new) joined.members.emplace_back();
      joined.members[at->second].push_back(p);
    }
    joined.complex.polygons.clear();
    joined.input.polygons.clear();
    std::erase_if(joined.complex.segments, [&](const Simplex& s) { return removed.contains(s); });
    for (const std::vector<std::size_t>& members : joined.members) {
      add_polygon(members, removed, joined);
    }
    return joined;
  }

 private:
  void add_polygon(const std::vector<std::size_t>& members, const std::set<Simplex>& removed,
                   JoinedPolygons& joined) const {
    if (members.size() == 1) {
      joined.complex.polygons.push_back(complex_.polygons[members[0]]);
      joined.input.polygons.push_back(input_.polygons[members[0]]);
      return;
    }
    Polygon polygon;
    polygon.axes = complex_.polygons[members[0]].axes;
    std::set<Simplex> of_members;
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    for (const std::size_t p : members) {
      const Polygon& member = complex_.polygons[p];
      append(polygon.vertices, member.vertices);
      append(polygon.triangles, member.triangles);
      of_members.insert(member.segments.begin(), member.segments.end());
    }
    keep_each_once(polygon.vertices);
    keep_each_once(polygon.triangles);
    std::set_difference(of_members.begin(), of_members.end(), removed.begin(), removed.end(),
                        std::back_inserter(polygon.segments));
    polygon.hole_seeds = seeds_in_holes(complex_.points, polygon, of_members);
    joined.input.polygons.push_back(lines_of(polygon));
    joined.complex.polygons.push_back(std::move(polygon));
  }

  // Its segments and, each by itself, the vertices that are in none of them.
  static PolygonLines lines_of(const Polygon& polygon) {
    PolygonLines lines{{}, polygon.hole_seeds};
    std::set<Vertex> ends;
    for (const Simplex& segment : polygon.segments) {
      lines.lines.push_back(segment);
      ends.insert(segment.begin(), segment.end());
    }
    for (const Vertex v : polygon.vertices) {
      if (!ends.contains(v)) lines.lines.push_back({v});
    }
    return lines;
  }

  const PiecewiseLinearInput& input_;
  const PiecewiseLinearComplex& complex_;
  DisjointSets groups_;
  std::vector<SegmentUse> uses_;
};

}  // namespace

std::vector<Simplex> listed_segments(const PiecewiseLinearInput& input) {
  std::vector<Simplex> listed;
  for (const auto& segment : input.segments) listed.push_back(sorted(segment));
  for (const PolygonLines& polygon : input.polygons) {
    for (const auto& line : polygon.lines) {
      if (line.size() == 2) listed.push_back(sorted(line));
    }
  }
  keep_each_once(listed);
  return listed;
}

bool share_segments_in_one_plane(const PiecewiseLinearComplex& complex) {
  const std::vector<SegmentUse> uses = segment_uses(complex);
  const auto never = [](std::size_t, std::size_t) { return false; };
  return !all_segments(uses, [&](std::span<const SegmentUse> at_one) {
    return all_in_one_plane(complex, at_one, never);
  });
}

JoinedPolygons coplanar_polygons_joined(const PiecewiseLinearInput& input,
                                        const PiecewiseLinearComplex& complex) {
  return JoiningOfPolygons(input, complex).result();
}

}  // namespace circumspect
