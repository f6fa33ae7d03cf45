#include "reference/constrained/delete_vertex.hpp"

#include <algorithm>
#include <map>

#include "reference/constrained/gift_wrap_cavity.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect::constrained {
namespace {

// Walls or hull facets at v that lie in one plane and are joined by edges at v.
struct Fan {
  std::vector<Simplex> facets;
  bool is_wall = false;
  bool is_on_hull = false;
};

// A facet at v that stays in its plane, and whether it is in a fan already.
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
    std::map<Simplex, FanFacet> facets;  // those that are to be in a fan
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

  // Does the other facet lie in the plane of the facet, beyond an edge at v that is no segment?
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
