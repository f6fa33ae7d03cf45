#include "reference/constrained/crossed_tetrahedra.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::constrained {
namespace {

// A point in the relative interior of the section of the simplex with the plane of the polygon: the
// mean of the section's corners. Requires: the polygon parts the simplex.
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
    const std::size_t x = polygon_.axes[0], y = polygon_.axes[1];
    const Point& o = points_[v];
    const Rational value = (p[x] - o[x]) * (q[y] - o[y]) - (p[y] - o[y]) * (q[x] - o[x]);
    return sign(value);
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
            polygon.is_inside_near(v, barycentre(coordinates(polygon.points(), facet)))) {
          included.insert(facet);
        }
      }
    }
  }
  return included;
}

}  // namespace circumspect::constrained
