#include "reference/constrained/cavity.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/constrained/clear_apex.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/flip_algorithm.hpp"

namespace circumspect::constrained {
namespace {

// A point in the relative interior of the section of the simplex with the plane of the polygon: the
// mean of the section's corners. Requires: the polygon's plane divides the simplex.
Point point_of_section(const PolygonInSpace& polygon, const Simplex& simplex) {
  std::vector<Point> corners;
  for (const Vertex v : simplex) {
    if (polygon.side(v) == 0) corners.push_back(polygon.points()[v]);
    for (const Vertex w : simplex) {
      if (polygon.side(v) >= 0 || polygon.side(w) <= 0) continue;
      const Rational share = polygon.distance(v) / (polygon.distance(v) - polygon.distance(w));
      corners.push_back(polygon.points()[v] + share * (polygon.points()[w] - polygon.points()[v]));
    }
  }
  return barycentre(corners);
}

// Requires: v is a vertex of the tetrahedron and of the polygon.
bool is_crossed(const PolygonInSpace& polygon, const Simplex& tetrahedron, Vertex v) {
  return polygon.parts(tetrahedron) &&
         polygon.is_inside_near(v, point_of_section(polygon, tetrahedron));
}

}  // namespace

PolygonInSpace::PolygonInSpace(const PointSet& points, const Polygon& polygon)
    : points_(points), polygon_(polygon) {
  assert(points.ambient_dimension() == 3 && !polygon.triangles.empty());
  doubled_area_ =
      orientation_determinant(points.configuration(), polygon.axes, polygon.triangles.front());
  for (const Simplex& triangle : polygon.triangles) {
    for (const Vertex v : triangle) triangles_at_[v].push_back(triangle);
  }
}

const Rational& PolygonInSpace::distance(Vertex v) const {
  const auto [place, is_new] = distances_.try_emplace(v);
  if (is_new) {
    Simplex tetrahedron = polygon_.triangles.front();
    tetrahedron.push_back(v);
    place->second =
        orientation_determinant(points_.configuration(), kSpace, tetrahedron) / doubled_area_;
  }
  return place->second;
}

bool PolygonInSpace::parts(const Simplex& simplex) const {
  bool left = false, right = false;
  for (const Vertex v : simplex) {
    left |= side(v) < 0;
    right |= side(v) > 0;
  }
  return left && right;
}

bool PolygonInSpace::is_coplanar(const Simplex& simplex) const {
  return std::all_of(simplex.begin(), simplex.end(), [&](Vertex v) { return side(v) == 0; });
}

bool PolygonInSpace::is_inside_near(Vertex v, const Point& towards) const {
  const auto at_v = triangles_at_.find(v);
  if (at_v == triangles_at_.end()) return false;  // v is the end of a segment that dangles
  const auto turn = [&](const Point& p, const Point& q) {
    return sign(cross_product(p - points_[v], q - points_[v], polygon_.axes[0], polygon_.axes[1]));
  };
  return std::any_of(at_v->second.begin(), at_v->second.end(), [&](const Simplex& triangle) {
    const Simplex others = without(triangle, {v});
    const Point& a = points_[others[0]];
    const Point& b = points_[others[1]];
    const int own = turn(a, b);
    return turn(a, towards) * own >= 0 && turn(towards, b) * own >= 0;
  });
}

std::set<Simplex> crossed_tetrahedra(const StarIndex& tetrahedra, const PolygonInSpace& polygon) {
  std::set<Simplex> crossed;
  std::vector<Simplex> pending;
  const auto visit = [&](const Simplex& tetrahedron) {
    if (crossed.insert(tetrahedron).second) pending.push_back(tetrahedron);
  };
  const auto search = [&] {
    while (!pending.empty()) {
      const Simplex tetrahedron = pending.back();
      pending.pop_back();
      for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
        const Simplex facet = facet_opposite(tetrahedron, place);
        if (!polygon.parts(facet)) continue;
        const std::vector<Simplex> sides = tetrahedra.star(facet);
        assert(sides.size() == 2);  // The polygon does not leave the convex hull.
        for (const Simplex& side : sides) visit(side);
      }
    }
  };
  for (const Vertex v : polygon.polygon().vertices) {
    for (const Simplex& tetrahedron : tetrahedra.star({v})) {
      if (crossed.contains(tetrahedron) || !is_crossed(polygon, tetrahedron, v)) continue;
      visit(tetrahedron);
      search();
    }
  }
  return crossed;
}

std::set<Simplex> facets_included_in(const StarIndex& tetrahedra, const PolygonInSpace& polygon) {
  std::set<Simplex> included;
  for (const Vertex v : polygon.polygon().vertices) {
    for (const Simplex& tetrahedron : tetrahedra.star({v})) {
      for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
        const Simplex facet = facet_opposite(tetrahedron, place);
        if (contains(facet, v) && polygon.is_coplanar(facet) &&
            polygon.is_inside_near(v, barycentre(polygon.points(), facet))) {
          included.insert(facet);
        }
      }
    }
  }
  return included;
}

namespace {

// Finish: a candidate counts if no facet of the cavity reaches into its simplex with the facet.
std::optional<Vertex> apex_in_cavity(const PointSet& points, const Cavity& cavity,
                                     const std::vector<OrientedFacet>& cavity_facets,
                                     const OrientedFacet& facet) {
  const auto is_clear = [&](const Simplex& simplex) {
    return std::none_of(cavity_facets.begin(), cavity_facets.end(),
                        [&](const OrientedFacet& other) {
                          return meets_interior(points, cavity.axes, simplex, other.vertices);
                        });
  };
  return first_clear_apex(points, cavity.axes, facet, cavity.candidates, is_clear).apex;
}

}  // namespace

Cavity cavity_of(const PointSet& points, const std::vector<std::size_t>& axes,
                 const std::set<Simplex>& walls, const std::vector<Simplex>& deleted) {
  Cavity cavity;
  cavity.axes = axes;
  std::vector<Simplex> positive;
  for (const Simplex& simplex : deleted)
    positive.push_back(positively_oriented(points, axes, simplex));
  for (const auto uses : ByFacet(facet_uses(positive))) {
    if (uses.size() == 2 && !walls.contains(uses.front().facet)) continue;
    for (const FacetUse& use : uses) {
      cavity.facets.add(OrientedFacet::opposite(positive[use.simplex], use.opposite));
    }
  }
  const std::set<Vertex> vertices = vertices_of(deleted);
  cavity.candidates.assign(vertices.begin(), vertices.end());
  return cavity;
}

tl::expected<std::vector<Simplex>, NoChange> gift_wrap_cavity(const PointSet& points,
                                                              const Cavity& cavity) {
  const std::vector<OrientedFacet> cavity_facets = cavity.facets.all();
  UnfinishedFacets unfinished = cavity.facets;
  SimplexDictionary finished;
  while (!unfinished.empty()) {
    const OrientedFacet facet = unfinished.first();
    const auto apex = apex_in_cavity(points, cavity, cavity_facets, facet);
    if (!apex) return tl::unexpected(NoChange{WhyNoChange::kFacetUnfinished, facet.vertices});
    const Simplex simplex = join(facet, *apex);
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const OrientedFacet side = OrientedFacet::opposite(simplex, place);
      if (finished.adjacent(side)) {
        return tl::unexpected(NoChange{WhyNoChange::kSimplicesOverlap, side.vertices});
      }
    }
    finished.add(simplex);
    unfinished.adjoin(simplex);
  }
  std::vector<Simplex> simplices = finished.simplices();
  for (Simplex& simplex : simplices) simplex = sorted(std::move(simplex));
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

std::optional<NoChange> insert_polygon_by_cavity(const PointSet& points, EvolvingCdt& cdt,
                                                 const Polygon& polygon) {
  for (const Simplex& segment : polygon.segments) {
    if (cdt.tetrahedra.star(segment).empty()) {
      return NoChange{WhyNoChange::kSegmentMissing, segment};
    }
  }
  const PolygonInSpace in_space(points, polygon);
  const std::set<Simplex> crossed = crossed_tetrahedra(cdt.tetrahedra, in_space);
  Change change{{crossed.begin(), crossed.end()}, {}};
  if (!crossed.empty()) {
    Cavity cavity = cavity_of(points, {0, 1, 2}, cdt.walls, change.deleted);
    for (const Simplex& facet : planar_cdt(points, polygon)) {
      if (!cdt.tetrahedra.star(facet).empty()) continue;
      cavity.facets.add(OrientedFacet::of(facet));
      cavity.facets.add(OrientedFacet::of(facet).reverse());
      change.walls_added.insert(facet);
    }
    auto created = gift_wrap_cavity(points, cavity);
    if (!created) return created.error();
    change.created = *std::move(created);
    if (const auto wrong = try_change(points, cdt, change)) return wrong;
  }
  cdt.walls.merge(facets_included_in(cdt.tetrahedra, in_space));
  return std::nullopt;
}

namespace {

// Adds the tetrahedra on both sides of facets that are not walls. False if there are no new ones.
bool grow(const EvolvingCdt& cdt, const std::set<Simplex>& walls, std::set<Simplex>& cavity,
          const std::vector<Simplex>& facets) {
  const std::size_t before = cavity.size();
  for (const Simplex& facet : facets) {
    if (walls.contains(facet)) continue;
    for (const Simplex& side : cdt.tetrahedra.star(facet)) cavity.insert(side);
  }
  return cavity.size() > before;
}

std::optional<NoChange> rewrap(const PointSet& points, EvolvingCdt& cdt,
                               const std::set<Simplex>& walls, Change change) {
  auto created = gift_wrap_cavity(points, cavity_of(points, {0, 1, 2}, walls, change.deleted));
  if (!created) return created.error();
  change.created = *std::move(created);
  return try_change(points, cdt, change);
}

}  // namespace

std::optional<NoChange> delete_polygon(const PointSet& points, EvolvingCdt& cdt,
                                       const Polygon& polygon) {
  const std::set<Simplex> included =
      facets_included_in(cdt.tetrahedra, PolygonInSpace(points, polygon));
  for (const Simplex& facet : included) {
    assert(cdt.tetrahedra.star(facet).size() == 2 || is_on_hull(points, cdt, facet));
  }
  std::set<Simplex> walls;
  std::set_difference(cdt.walls.begin(), cdt.walls.end(), included.begin(), included.end(),
                      std::inserter(walls, walls.end()));
  std::vector<Simplex> bad;
  std::copy_if(included.begin(), included.end(), std::back_inserter(bad),
               [&](const Simplex& facet) {
                 return !delaunay::is_locally_delaunay(points, cdt.tetrahedra, facet,
                                                       delaunay::FlipTest::kPerturbed);
               });
  std::set<Simplex> cavity;
  grow(cdt, walls, cavity, bad);
  for (;;) {
    Change change{{cavity.begin(), cavity.end()}, {}};
    change.walls_removed = included;
    const auto wrong = rewrap(points, cdt, walls, change);
    if (!wrong) return std::nullopt;
    const bool has_grown = (wrong->why == WhyNoChange::kNotLocallyDelaunay &&
                            grow(cdt, walls, cavity, {wrong->witness})) ||
                           grow(cdt, walls, cavity, facets_of(change.deleted));
    if (!has_grown) return wrong;
  }
}

}  // namespace circumspect::constrained
