#include "reference/constrained/insert_vertex.hpp"

#include <algorithm>
#include <cassert>
#include <map>

#include "reference/complex/facets.hpp"
#include "reference/complex/oriented_facet.hpp"
#include "reference/predicates/orientation.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect::constrained {
namespace {

bool contains_point(const PointSet& points, const Simplex& tetrahedron, Vertex v) {
  const int own = orientation(points.configuration(), tetrahedron);
  for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
    const Simplex replaced = with_vertex_replaced(tetrahedron, place, v);
    if (own * orientation(points.configuration(), replaced) < 0) return false;
  }
  return true;
}

bool is_collinear(const PointSet& points, const Simplex& edge, Vertex v) {
  return axes_of(points.configuration(), Simplex{edge[0], edge[1], v}).size() < 2;
}

// Requires: v is on the line of the segment.
bool is_inside(const PointSet& points, const Simplex& segment, Vertex v) {
  const Point& p = points[v];
  return sign(inner_product(points[segment[0]] - p, points[segment[1]] - p)) < 0;
}

class VertexInsertion {
 public:
  VertexInsertion(const PointSet& points, EvolvingCdt& cdt, Vertex v)
      : points_(points), cdt_(cdt), v_(v) {}

  std::optional<NoChange> run() {
    if (!cdt_.tetrahedra.star({v_}).empty())
      return NoChange{WhyNoChange::kVertexAlreadyThere, {v_}};
    dig_cavity();
    if (change_.deleted.empty()) {
      assert(is_beyond_hull());
      return NoChange{WhyNoChange::kOutsideHull, {v_}};
    }
    if (const auto wrong = find_border()) return wrong;
    if (const auto wrong = find_buried_segments()) return wrong;
    for (const OrientedFacet& facet : border_) change_.created.push_back(sorted(join(facet, v_)));
    join_walls_to_vertex();
    return try_change(points_, cdt_, change_);
  }

 private:
  // DigCavity3D, starting from the tetrahedra that contain v.
  void dig_cavity() {
    std::set<Simplex> cavity;
    std::vector<Simplex> pending;
    const auto dig = [&](const Simplex& tetrahedron) {
      if (cavity.insert(tetrahedron).second) pending.push_back(tetrahedron);
    };
    for (const Simplex& tetrahedron : cdt_.tetrahedra.simplices()) {
      if (contains_point(points_, tetrahedron, v_)) dig(tetrahedron);
    }
    while (!pending.empty()) {
      const Simplex tetrahedron = pending.back();
      pending.pop_back();
      for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
        const Simplex facet = facet_opposite(tetrahedron, place);
        if (cdt_.walls.contains(facet)) continue;
        for (const Simplex& side : cdt_.tetrahedra.star(facet)) {
          if (perturbed_in_ball(points_.configuration(), side, v_) > 0) dig(side);
        }
      }
    }
    change_.deleted.assign(cavity.begin(), cavity.end());
  }

  // The facets of the cavity; each must have v strictly in front, but those of the hull that v is
  // on. What walls there are inside must pass through v.
  std::optional<NoChange> find_border() {
    std::vector<Simplex> positive;
    for (const Simplex& tetrahedron : change_.deleted) {
      positive.push_back(positively_oriented(points_, tetrahedron));
    }
    std::optional<NoChange> wrong;
    for_each_facet(facet_uses(positive), [&](std::span<const FacetUse> uses) {
      const Simplex& facet = uses.front().facet;
      const bool is_wall = cdt_.walls.contains(facet);
      if (wrong || (uses.size() == 2 && !is_wall)) return;
      const OrientedFacet inward =
          OrientedFacet::opposite(positive[uses.front().simplex], uses.front().opposite);
      const int side = orientation(points_.configuration(), join(inward, v_));
      const bool is_of_hull = is_on_hull(points_, cdt_, facet);
      if (side == 0 && (uses.size() == 2 || is_of_hull)) {
        if (is_wall) change_.walls_removed.insert(facet);
      } else if (uses.size() == 2) {
        wrong = NoChange{WhyNoChange::kPolygonInCavity, facet};
      } else if (side <= 0) {
        wrong = NoChange{WhyNoChange::kNotStarShaped, facet};
      } else {
        border_.push_back(inward);
      }
    });
    return wrong;
  }

  // Is v beyond a facet of the convex hull?
  bool is_beyond_hull() const {
    for (const Simplex& tetrahedron : cdt_.tetrahedra.simplices()) {
      for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
        const Simplex facet = facet_opposite(tetrahedron, place);
        const Simplex replaced = with_vertex_replaced(tetrahedron, place, v_);
        const bool is_beyond = orientation(points_.configuration(), tetrahedron) *
                                   orientation(points_.configuration(), replaced) <
                               0;
        if (is_beyond && is_on_hull(points_, cdt_, facet)) return true;
      }
    }
    return false;
  }

  // Segments in the interior of the cavity. Vertices there are none: suppose that all tetrahedra at a
  // vertex u are in the cavity, and no facet at u bounds it. Then the line from v to u goes on in one
  // of them, τ. (If u is on the hull, v is in the planes of all its facets at u, and they meet in more
  // than u, so along that line.) The sphere of τ passes through u, and its ball has points beyond u on
  // the line. So v is strictly outside, perturbed or not, and τ does not contain v: it was never dug.
  std::optional<NoChange> find_buried_segments() {
    std::vector<Simplex> facets;
    for (const OrientedFacet& facet : border_) facets.push_back(facet.vertices);
    const std::set<Simplex> edges = edges_of(facets);
    for (const Simplex& edge : edges_of(change_.deleted)) {
      if (!cdt_.segments.contains(edge)) continue;
      if (is_collinear(points_, edge, v_) && is_inside(points_, edge, v_)) {
        change_.segments_removed.insert(edge);
        for (const Vertex end : edge) change_.segments_added.insert(sorted({end, v_}));
      } else if (!edges.contains(edge)) {
        return NoChange{WhyNoChange::kSegmentInCavity, edge};
      }
    }
    const std::set<Vertex> vertices = vertices_of(facets);
    for (const Vertex u : vertices_of(change_.deleted)) assert(vertices.contains(u));
    return std::nullopt;
  }

  // The walls through v: from v to each edge that bounds, within their plane, those that were
  // there.
  void join_walls_to_vertex() {
    std::map<Simplex, int> uses;
    for (const Simplex& wall : change_.walls_removed) {
      for (const Simplex& edge : edges_of({wall})) ++uses[edge];
    }
    for (const auto& [edge, count] : uses) {
      if (count == 1 && !is_collinear(points_, edge, v_)) {
        change_.walls_added.insert(join(edge, {v_}));
      }
    }
  }

  const PointSet& points_;
  EvolvingCdt& cdt_;
  const Vertex v_;
  std::vector<OrientedFacet> border_;  // v in front
  Change change_ = {};
};

}  // namespace

std::optional<NoChange> insert_vertex(const PointSet& points, EvolvingCdt& cdt, Vertex v) {
  return VertexInsertion(points, cdt, v).run();
}

}  // namespace circumspect::constrained
