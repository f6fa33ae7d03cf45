#include "oracle/judge/convex_hull/star_conditions.hpp"

#include <map>

#include "kernel/boxes/point_search.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

Simplex joined(Simplex simplex, std::initializer_list<Vertex> more) {
  simplex.insert(simplex.end(), more);
  return simplex;
}

// The points of the set, then o, then the centre of the first facet.
std::vector<Point> with_inside(const PointSet& points, const std::vector<Simplex>& facets) {
  std::vector<Point> all = points.points();
  std::vector<Point> basis;
  for (const std::size_t v : points.configuration().hull().basis) basis.push_back(all[v]);
  all.push_back(barycentre(basis));
  all.push_back(barycentre(points, facets.front()));
  return all;
}

class SeenFromInside {
 public:
  SeenFromInside(const PointSet& points, const std::vector<Simplex>& facets)
      : facets_(facets),
        points_(with_inside(points, facets)),
        inside_(static_cast<Vertex>(points.size())),
        is_vertex_(points.size(), false) {
    for (const Simplex& facet : facets) {
      for (const Vertex v : facet) is_vertex_[static_cast<std::size_t>(v)] = true;
    }
  }

  std::optional<HeldHull> held() {
    if (!are_beside_inside() || !ridges_are_convex() || !first_is_alone()) return std::nullopt;
    std::vector<std::size_t> others;
    for (std::size_t q = 0; q < is_vertex_.size(); ++q) {
      if (!is_vertex_[q]) others.push_back(q);
    }
    const std::vector<std::size_t> within = PointSearch(*this).simplices_with(others);
    HeldHull held;
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (within[i] == kNoSimplex) return std::nullopt;
      if (side(within[i], facets_[within[i]].size(), others[i]) == 0) {
        held.beside.push_back(static_cast<Vertex>(others[i]));
      }
    }
    return held;
  }

  // The simplices that join o to the facets: once the first four conditions hold, they triangulate
  // a convex set. The interface that PointSearch asks for; o is their last vertex.
  std::size_t size() const { return facets_.size(); }
  std::size_t row_size() const { return facets_.front().size() + 1; }
  std::size_t points() const { return points_.size(); }
  std::size_t vertex(std::size_t s, std::size_t place) const {
    const bool is_inside = place == facets_[s].size();
    return static_cast<std::size_t>(is_inside ? inside_ : facets_[s][place]);
  }
  int side(std::size_t s, std::size_t place, std::size_t point) const {
    const Simplex simplex = joined(facets_[s], {inside_});
    return inner_[s] *
           orientation(points_, with_vertex_replaced(simplex, place, static_cast<Vertex>(point)));
  }
  std::size_t across(std::size_t s, std::size_t place) const {
    const std::size_t size = facets_[s].size();
    return place == size ? kNoSimplex : across_[s * size + place];
  }

 private:
  int side_of(std::size_t facet, Vertex q) const {
    return side_of_facet(points_, facets_[facet], q);
  }

  bool are_beside_inside() {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      inner_.push_back(side_of(f, inside_));
      if (inner_.back() == 0) return false;
    }
    return true;
  }

  bool ridges_are_convex() {
    const std::size_t size = facets_.front().size();
    across_.assign(facets_.size() * size, 0);
    bool are = true;
    for (const auto group : ByFacet(facet_uses(facets_))) {
      are = are && group.size() == 2 && is_convex(group[0], group[1]);
      if (!are) break;
      across_[group[0].simplex * size + group[0].opposite] = group[1].simplex;
      across_[group[1].simplex * size + group[1].opposite] = group[0].simplex;
    }
    return are;
  }

  bool is_convex(const FacetUse& a, const FacetUse& b) const {
    const Vertex of_a = facets_[a.simplex][a.opposite], of_b = facets_[b.simplex][b.opposite];
    const int beside_a = orientation(points_, joined(a.facet, {of_a, inside_}));
    const int beside_b = orientation(points_, joined(a.facet, {of_b, inside_}));
    return beside_a * beside_b < 0 && side_of(a.simplex, of_b) * inner_[a.simplex] >= 0;
  }

  // The centre of the first facet is outside of the cones over all others.
  bool first_is_alone() const {
    const auto centre = static_cast<std::size_t>(inside_ + 1);
    for (std::size_t f = 1; f < facets_.size(); ++f) {
      bool is_in_cone = true;
      for (std::size_t place = 0; place < facets_[f].size(); ++place) {
        is_in_cone = is_in_cone && side(f, place, centre) >= 0;
      }
      if (is_in_cone) return false;
    }
    return true;
  }

  const std::vector<Simplex>& facets_;
  Configuration points_;
  Vertex inside_;
  std::vector<bool> is_vertex_;
  std::vector<int> inner_;           // the side of each facet on which o is
  std::vector<std::size_t> across_;  // across the ridge opposite each vertex of each facet
};

// In the coordinates of the affine hull.
Point on_axes(const PointSet& points, const Point& point) {
  Point own;
  for (const std::size_t axis : points.configuration().axes()) own.push_back(point[axis]);
  return own;
}

}  // namespace

std::optional<HeldHull> held_hull(const PointSet& points, const std::vector<Simplex>& facets) {
  if (facets.empty()) return std::nullopt;
  return SeenFromInside(points, facets).held();
}

// The hyperplane of a facet is {x | n·(x − o) = 1} for one n. Those of the facets at v meet in v
// alone if and only if their n, which are in {n | n·(v − o) = 1}, span all of it.
std::vector<Vertex> not_extreme(const PointSet& points, const std::vector<Simplex>& facets) {
  const auto k = static_cast<std::size_t>(points.dimension());
  std::vector<Point> basis;
  for (const std::size_t v : points.configuration().hull().basis) {
    basis.push_back(on_axes(points, points.points()[v]));
  }
  const Point inside = barycentre(basis);
  std::map<Vertex, std::vector<Point>> planes_at;
  for (const Simplex& facet : facets) {
    RationalMatrix rows;
    for (const Vertex v : facet) rows.push_back(on_axes(points, points[v]) - inside);
    const auto plane = solve(rows, std::vector<Rational>(k, 1));
    for (const Vertex v : facet) planes_at[v].push_back(plane.value());
  }
  std::vector<Vertex> found;
  for (const auto& [v, planes] : planes_at) {
    if (affine_hull(planes).dimension + 1 < points.dimension()) found.push_back(v);
  }
  return found;
}

}  // namespace circumspect::check
