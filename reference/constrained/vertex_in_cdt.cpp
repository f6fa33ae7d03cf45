#include "reference/constrained/vertex_in_cdt.hpp"

#include <algorithm>
#include <cassert>
#include <map>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "kernel/predicates/place.hpp"
#include "reference/constrained/cavity.hpp"

namespace circumspect::constrained {

namespace {

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
      if (lies_in(points_.configuration(), kSpace, tetrahedron, v_)) dig(tetrahedron);
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

  // The facets of the cavity; each must have v strictly in front, except those of the hull that
  // contain v. Walls inside must pass through v.
  std::optional<NoChange> find_border() {
    std::vector<Simplex> positive;
    for (const Simplex& tetrahedron : change_.deleted) {
      positive.push_back(positively_oriented(points_, tetrahedron));
    }
    for (const auto uses : ByFacet(facet_uses(positive))) {
      const Simplex& facet = uses.front().facet;
      const bool is_wall = cdt_.walls.contains(facet);
      if (uses.size() == 2 && !is_wall) continue;
      const OrientedFacet inward =
          OrientedFacet::opposite(positive[uses.front().simplex], uses.front().opposite);
      const int side = orientation(points_.configuration(), join(inward, v_));
      const bool is_of_hull = is_on_hull(points_, cdt_, facet);
      if (side == 0 && (uses.size() == 2 || is_of_hull)) {
        if (is_wall) change_.walls_removed.insert(facet);
      } else if (uses.size() == 2) {
        return NoChange{WhyNoChange::kPolygonInCavity, facet};
      } else if (side <= 0) {
        return NoChange{WhyNoChange::kNotStarShaped, facet};
      } else {
        border_.push_back(inward);
      }
    }
    return std::nullopt;
  }

  // Is v beyond a facet of the convex hull?
  bool is_beyond_hull() const {
    for (const Simplex& tetrahedron : cdt_.tetrahedra.simplices()) {
      for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
        const Simplex facet = facet_opposite(tetrahedron, place);
        const int side = barycentric_sign(points_.configuration(), tetrahedron, place, v_);
        if (side < 0 && is_on_hull(points_, cdt_, facet)) return true;
      }
    }
    return false;
  }

  // Segments in the interior of the cavity. There are no vertices: suppose that all tetrahedra at a
  // vertex u are in the cavity, and no facet at u bounds it. Then the line from v to u continues in
  // one of them, τ. (If u is on the hull, v is in the planes of all its facets at u, and they meet
  // in more than u, so along that line.) The sphere of τ passes through u, and its ball has points
  // beyond u on the line. So v is strictly outside, perturbed or not, and τ does not contain v: it
  // was never dug.
  std::optional<NoChange> find_buried_segments() {
    std::vector<Simplex> facets;
    for (const OrientedFacet& facet : border_) facets.push_back(facet.vertices);
    const std::set<Simplex> edges = edges_of(facets);
    for (const Simplex& edge : edges_of(change_.deleted)) {
      if (!cdt_.segments.contains(edge)) continue;
      if (lies_inside_segment(points_.configuration(), edge, v_)) {
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

  // The walls through v: triangles from v to each edge on the boundary, within their plane, of the
  // walls that they replace.
  void join_walls_to_vertex() {
    std::map<Simplex, int> uses;
    for (const Simplex& wall : change_.walls_removed) {
      for (const Simplex& edge : edges_of({wall})) ++uses[edge];
    }
    for (const auto& [edge, count] : uses) {
      if (count == 1 && !is_on_line_of(edge)) {
        change_.walls_added.insert(join(edge, {v_}));
      }
    }
  }

  bool is_on_line_of(const Simplex& edge) const {
    const Configuration& points = points_.configuration();
    return is_in_hull_of(points, axes_of(points, edge), edge, v_);
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

namespace {

// Walls or hull facets at v that lie in one plane and are joined by edges at v.
struct Fan {
  std::vector<Simplex> facets;
  bool is_wall = false;
  bool is_on_hull = false;
};

// A facet at v that stays in its plane, and whether it is already in a fan.
struct FanFacet {
  bool is_wall = false;
  bool is_on_hull = false;
  bool is_taken = false;
};

class VertexDeletion {
 public:
  VertexDeletion(const PointSet& points, EvolvingCdt& cdt, Vertex v)
      : points_(points), cdt_(cdt), v_(v) {
    change_.deleted = cdt.tetrahedra.star({v});
  }

  std::optional<NoChange> run() {
    if (change_.deleted.empty()) return NoChange{WhyNoChange::kVertexNeeded, {v_}};
    if (const auto wrong = merge_segments()) return wrong;
    Cavity cavity = cavity_of(points_, {0, 1, 2}, {}, change_.deleted);
    for (const OrientedFacet& facet : cavity.facets.all()) {
      if (contains(facet.vertices, v_)) cavity.facets.remove(facet);
    }
    std::erase(cavity.candidates, v_);
    for (const Fan& fan : fans()) {
      if (const auto wrong = close(fan, cavity)) return wrong;
    }
    auto created = gift_wrap_cavity(points_, cavity);
    if (!created) return created.error();
    change_.created = *std::move(created);
    return try_change(points_, cdt_, change_);
  }

 private:
  std::optional<NoChange> merge_segments() {
    Simplex ends;
    for (const Simplex& edge : edges_of(change_.deleted)) {
      if (!contains(edge, v_) || !cdt_.segments.contains(edge)) continue;
      change_.segments_removed.insert(edge);
      ends.push_back(without(edge, {v_}).front());
    }
    if (ends.empty()) return std::nullopt;
    if (ends.size() != 2 || !is_parted_by_v(ends)) {
      return NoChange{WhyNoChange::kVertexNeeded, *change_.segments_removed.begin()};
    }
    change_.segments_added.insert(sorted(ends));
    return std::nullopt;
  }

  bool is_parted_by_v(const Simplex& ends) const {
    const Simplex three = {ends[0], ends[1], v_};
    return axes_of(points_.configuration(), three).size() == 1 &&
           sign(inner_product(points_[ends[0]] - points_[v_], points_[ends[1]] - points_[v_])) < 0;
  }

  bool is_coplanar(const Simplex& a, const Simplex& b) const {
    Simplex all = join(a, without(b, a));
    return orientation(points_.configuration(), all) == 0;
  }

  std::vector<Fan> fans() const {
    std::map<Simplex, FanFacet> facets;  // those that must be in a fan
    for (const Simplex& facet : facets_of(change_.deleted)) {
      if (!contains(facet, v_)) continue;
      const FanFacet kind{cdt_.walls.contains(facet), is_on_hull(points_, cdt_, facet)};
      if (kind.is_wall || kind.is_on_hull) facets[facet] = kind;
    }
    std::vector<Fan> all;
    for (auto& [first, kind] : facets) {
      if (kind.is_taken) continue;
      kind.is_taken = true;
      Fan fan{{first}, kind.is_wall, kind.is_on_hull};
      for (std::size_t i = 0; i < fan.facets.size(); ++i) {
        for (auto& [other, other_kind] : facets) {
          const bool is_alike =
              kind.is_wall == other_kind.is_wall && kind.is_on_hull == other_kind.is_on_hull;
          if (other_kind.is_taken || !is_alike || !continues(fan.facets[i], other)) continue;
          other_kind.is_taken = true;
          fan.facets.push_back(other);
        }
      }
      std::sort(fan.facets.begin(), fan.facets.end());
      all.push_back(std::move(fan));
    }
    return all;
  }

  // Does the other facet lie in the plane of the facet, beyond an edge at v that is not a segment?
  bool continues(const Simplex& facet, const Simplex& other) const {
    const Simplex rest = without(facet, other);
    if (rest.size() != 1 || rest.front() == v_) return false;
    return !cdt_.segments.contains(without(facet, rest)) && is_coplanar(facet, other);
  }

  // Retriangulates a fan, and gives the facets to the cavity: on both sides of it, on the hull
  // inside.
  std::optional<NoChange> close(const Fan& fan, Cavity& cavity) {
    Cavity plane =
        cavity_of(points_, axes_of(points_.configuration(), fan.facets.front()), {}, fan.facets);
    Simplex ends;  // of the edges at v that bound the fan
    for (const OrientedFacet& edge : plane.facets.all()) {
      if (!contains(edge.vertices, v_)) continue;
      ends.push_back(without(edge.vertices, {v_}).front());
      plane.facets.remove(edge);
      // From end to end the edge faces as from v to end.
      if (ends.size() == 2) add_replacing_v(plane, edge, ends[0]);
    }
    if (!ends.empty() && (ends.size() != 2 || !is_parted_by_v(ends))) {
      return NoChange{WhyNoChange::kExtremeVertex, {v_}};
    }
    std::erase(plane.candidates, v_);
    const auto facets = gift_wrap_cavity(points_, plane);
    if (!facets) return facets.error();
    const Vertex inside =
        without(cdt_.tetrahedra.star(fan.facets.front()).front(), fan.facets.front()).front();
    for (const Simplex& facet : *facets) {
      OrientedFacet inward = OrientedFacet::of(facet);
      if (orientation(points_.configuration(), join(inward, inside)) < 0) inward = inward.reverse();
      cavity.facets.add(inward);
      if (!fan.is_on_hull) cavity.facets.add(inward.reverse());
      if (fan.is_wall) change_.walls_added.insert(facet);
    }
    if (fan.is_wall) change_.walls_removed.insert(fan.facets.begin(), fan.facets.end());
    return std::nullopt;
  }

  void add_replacing_v(Cavity& plane, const OrientedFacet& edge, Vertex other_end) const {
    Simplex moved = edge.vertices;
    std::replace(moved.begin(), moved.end(), v_, other_end);
    const OrientedFacet ascending = OrientedFacet::of(moved);
    plane.facets.add(edge.reversed ? ascending.reverse() : ascending);
  }

  const PointSet& points_;
  EvolvingCdt& cdt_;
  const Vertex v_;
  Change change_ = {};
};

}  // namespace

std::optional<NoChange> delete_vertex(const PointSet& points, EvolvingCdt& cdt, Vertex v) {
  return VertexDeletion(points, cdt, v).run();
}

}  // namespace circumspect::constrained
