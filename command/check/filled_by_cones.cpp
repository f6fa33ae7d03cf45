#include "command/check/filled_by_cones.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "construct/delaunay.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "reference/constrained/planar_cdt.hpp"

namespace circumspect::cli {
namespace {

// A triangle of the boundary of a pocket, and a point that is on one side of it.
struct PocketSide {
  Simplex triangle;  // ascending
  Point beside;
  bool is_pocket_there;  // or on the other side?
};

struct Plane {
  Point normal;
  Rational offset;
  bool has(const Point& point) const { return inner_product(normal, point) == offset; }
};

Plane plane_of(const PointSet& points, const Simplex& triangle) {
  const Point& p = points[triangle[0]];
  Plane plane{cross_product(points[triangle[1]] - p, points[triangle[2]] - p), 0};
  plane.offset = inner_product(plane.normal, p);
  return plane;
}

// The facets that one simplex alone has, each with its other vertex.
std::map<Simplex, Vertex> exposed(const std::vector<Simplex>& tetrahedra) {
  std::map<Simplex, Vertex> found;
  for (const auto group : ByFacet(facet_uses(tetrahedra))) {
    if (group.size() != 1) continue;
    const FacetUse& use = group.front();
    found.emplace(use.facet, tetrahedra[use.simplex][use.opposite]);
  }
  return found;
}

// The triangles of a face of the hull, which have all edges that the mesh has there: also those of
// triangles that leave the face.
std::vector<Simplex> triangles_of_face(const PointSet& points, const Plane& plane,
                                       const std::map<Simplex, Vertex>& walls) {
  std::size_t axis = 0;
  while (plane.normal[axis] == 0) ++axis;
  std::vector<Vertex> above;
  std::vector<Point> flat;
  for (Vertex v = 0; points.names(v); ++v) {
    if (!plane.has(points[v])) continue;
    above.push_back(v);
    flat.push_back(points[v]);
    flat.back().erase(flat.back().begin() + static_cast<std::ptrdiff_t>(axis));
  }
  const auto place = [&](Vertex v) {
    return static_cast<Vertex>(std::lower_bound(above.begin(), above.end(), v) - above.begin());
  };
  std::set<Simplex> edges;
  for (const auto& [triangle, apex] : walls) {
    for (const Simplex& edge : faces(triangle, 2)) {
      if (!plane.has(points[edge[0]]) || !plane.has(points[edge[1]])) continue;
      edges.insert({place(edge[0]), place(edge[1])});
    }
  }
  const PiecewiseLinearComplex complex{
      PointSet(std::move(flat)), {edges.begin(), edges.end()}, {}, {}, DomainKind::kHull};
  std::vector<Simplex> triangles = constrained::planar_cdt(complex).simplices;
  for (Simplex& triangle : triangles) {
    for (Vertex& v : triangle) v = above[static_cast<std::size_t>(v)];
    std::sort(triangle.begin(), triangle.end());
  }
  return triangles;
}

// The triangles of the hull, each with the other vertex of some tetrahedron inside.
std::map<Simplex, Vertex> hull_triangles(const PointSet& points,
                                         const std::map<Simplex, Vertex>& walls) {
  std::map<Point, std::pair<Plane, Vertex>> faces;  // by the direction that points out
  for (const auto& [facet, apex] :
       exposed(construct::any_canonical_delaunay(points).triangulation.simplices())) {
    const Plane plane = plane_of(points, facet);
    const bool is_outward = inner_product(plane.normal, points[apex]) < plane.offset;
    Rational length = 0;
    for (const Rational& x : plane.normal) length += abs(x);
    faces.emplace((is_outward ? 1 : -1) / length * plane.normal, std::pair(plane, apex));
  }
  std::map<Simplex, Vertex> found;
  for (const auto& [direction, face] : faces) {
    for (const Simplex& triangle : triangles_of_face(points, face.first, walls)) {
      found.emplace(triangle, face.second);
    }
  }
  return found;
}

bool sees_all(const WallSet& walls, const std::vector<PocketSide>& sides, const Point& point) {
  return std::all_of(sides.begin(), sides.end(), [&](const PocketSide& side) {
    const std::size_t wall = walls.place_of(side.triangle);
    const int beside = walls.side_of(wall, side.beside);
    return walls.side_of(wall, point) == (side.is_pocket_there ? beside : -beside);
  });
}

// The barycentre of the vertices, or the middle between the centres of two triangles.
std::optional<Point> centre_of(const PointSet& points, const WallSet& walls,
                               const std::vector<PocketSide>& sides) {
  std::set<Vertex> vertices;
  for (const PocketSide& side : sides) vertices.insert(side.triangle.begin(), side.triangle.end());
  const Point centre = barycentre(points, {vertices.begin(), vertices.end()});
  if (sees_all(walls, sides, centre)) return centre;
  constexpr std::size_t kMost = 24;
  for (std::size_t i = 0; i < std::min(kMost, sides.size()); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Point middle = barycentre(
          {barycentre(points, sides[i].triangle), barycentre(points, sides[j].triangle)});
      if (sees_all(walls, sides, middle)) return middle;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<certificate::FilledMesh> filled_by_cones(const ExactMesh& mesh) {
  const PointSet& points = mesh.points;
  if (points.dimension() != 3 || mesh.simplices.empty()) return std::nullopt;
  const std::map<Simplex, Vertex> walls = exposed(mesh.simplices);
  const std::map<Simplex, Vertex> hull = hull_triangles(points, walls);
  std::vector<Simplex> all;
  std::vector<PocketSide> sides;
  for (const auto& [triangle, apex] : walls) {
    all.push_back(triangle);
    if (!hull.contains(triangle)) sides.push_back({triangle, points[apex], false});
  }
  for (const auto& [triangle, apex] : hull) {
    if (walls.contains(triangle)) continue;
    all.push_back(triangle);
    sides.push_back({triangle, points[apex], true});
  }
  std::sort(all.begin(), all.end());
  const Regions regions(points, all, {}, DomainKind::kEnclosed);
  std::map<std::size_t, std::vector<PocketSide>> pockets;
  for (const PocketSide& side : sides) {
    const std::size_t wall = regions.walls().place_of(side.triangle);
    const bool is_in_front =
        (regions.walls().side_of(wall, side.beside) > 0) == side.is_pocket_there;
    pockets[regions.beside(wall)[is_in_front ? 1 : 0]].push_back(side);
  }
  std::vector<Point> further = points.points();
  certificate::FilledMesh filled{{points, mesh.simplices, mesh.labels, mesh.first_index}, {}};
  for (const auto& [region, around] : pockets) {
    const auto centre = centre_of(points, regions.walls(), around);
    if (!centre) return std::nullopt;
    for (const PocketSide& side : around) {
      filled.rest.push_back(side.triangle);
      filled.rest.back().push_back(static_cast<Vertex>(further.size()));
    }
    further.push_back(*centre);
    if (!mesh.labels.empty()) filled.mesh.labels.push_back(0);
  }
  filled.helpers = pockets.size();
  filled.mesh.points = PointSet(std::move(further));
  return filled;
}

}  // namespace circumspect::cli
