#include "reference/constrained/insert_vertex.hpp"

#include <algorithm>
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

  std::optional<Obstruction> run() {
    if (!cdt_.tetrahedra.star({v_}).empty())
      return Obstruction{Obstacle::kVertexAlreadyThere, {v_}};
    dig_cavity();
    if (change_.deleted.empty()) return Obstruction{Obstacle::kOutsideHull, {v_}};
    if (const auto wrong = find_border()) return wrong;
    if (const auto wrong = find_what_is_buried()) return wrong;
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
  std::optional<Obstruction> find_border() {
    std::vector<Simplex> positive;
    for (const Simplex& tetrahedron : change_.deleted) {
      positive.push_back(positively_oriented(points_, tetrahedron));
    }
    std::optional<Obstruction> wrong;
    for_each_facet(facet_uses(positive), [&](std::span<const FacetUse> uses) {
      const Simplex& facet = uses.front().facet;
      const bool is_wall = cdt_.walls.contains(facet);
      if (wrong || (uses.size() == 2 && !is_wall)) return;
      const OrientedFacet inward =
          OrientedFacet::opposite(positive[uses.front().simplex], uses.front().opposite);
      const int side = orientation(points_.configuration(), join(inward, v_));
      const bool is_on_hull = cdt_.tetrahedra.star(facet).size() == 1;
      if (side == 0 && (uses.size() == 2 || is_on_hull)) {
        if (is_wall) change_.walls_removed.insert(facet);
      } else if (uses.size() == 2) {
        wrong = Obstruction{Obstacle::kPolygonInCavity, facet};
      } else if (side <= 0) {
        wrong = Obstruction{Obstacle::kNotStarShaped, facet};
      } else {
        border_.push_back(inward);
      }
    });
    return wrong;
  }

  // Segments and vertices in the interior of the cavity.
  std::optional<Obstruction> find_what_is_buried() {
    std::vector<Simplex> facets;
    for (const OrientedFacet& facet : border_) facets.push_back(facet.vertices);
    const std::set<Simplex> edges = edges_of(facets);
    for (const Simplex& edge : edges_of(change_.deleted)) {
      if (!cdt_.segments.contains(edge)) continue;
      if (is_collinear(points_, edge, v_) && is_inside(points_, edge, v_)) {
        change_.segments_removed.insert(edge);
        for (const Vertex end : edge) change_.segments_added.insert(sorted({end, v_}));
      } else if (!edges.contains(edge)) {
        return Obstruction{Obstacle::kSegmentInCavity, edge};
      }
    }
    const std::set<Vertex> vertices = vertices_of(facets);
    for (const Vertex u : vertices_of(change_.deleted)) {
      if (!vertices.contains(u)) return Obstruction{Obstacle::kVertexInCavity, {u}};
    }
    return std::nullopt;
  }

  // The walls through v: from v to each edge that bounds, within their plane, those that were there.
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

std::optional<Obstruction> insert_vertex(const PointSet& points, EvolvingCdt& cdt, Vertex v) {
  return VertexInsertion(points, cdt, v).run();
}

}  // namespace circumspect::constrained
