#include "reference/delaunay/lifted_hull.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"

namespace circumspect::delaunay {

namespace {

// Is there an open circumball of the simplex that contains no point of S? Book: Section 4.2.
bool is_perturbed_delaunay(const PointSet& points, const Simplex& simplex) {
  for (Vertex q = 0; points.names(q); ++q) {
    if (contains(simplex, q)) continue;
    if (perturbed_in_ball(points.configuration(), simplex, q) > 0) return false;
  }
  return true;
}

}  // namespace

Triangulation by_definition(const PointSet& points) {
  const int k = points.dimension();
  std::vector<Simplex> simplices;
  if (points.empty()) return Triangulation(k, simplices);
  Simplex subset = first_subset(static_cast<std::size_t>(k) + 1);
  do {
    if (orientation(points.configuration(), subset) == 0) continue;
    if (is_perturbed_delaunay(points, subset)) simplices.push_back(subset);
  } while (next_subset(subset, points.size()));
  return Triangulation(k, std::move(simplices));
}

Triangulation least_vertex_triangulation(const PointSet& points, const PolyhedralComplex& complex) {
  const Configuration& configuration = points.configuration();
  std::map<Face, std::vector<Simplex>> triangulated;
  for (int j = 0; j <= complex.dimension(); ++j) {
    for (const Face& face : complex.faces(j)) {
      const Vertex least = *std::min_element(face.begin(), face.end(), [&](Vertex a, Vertex b) {
        return configuration.rank(a) < configuration.rank(b);
      });
      std::vector<Simplex>& simplices = triangulated[face];
      if (j == 0) simplices = {{least}};
      for (const Face& facet : complex.facets_of(face)) {
        if (contains(facet, least)) continue;
        for (Simplex simplex : triangulated.at(facet)) {
          simplex.push_back(least);
          simplices.push_back(std::move(simplex));
        }
      }
    }
  }
  std::vector<Simplex> all;
  for (const Face& cell : complex.cells()) {
    all.insert(all.end(), triangulated.at(cell).begin(), triangulated.at(cell).end());
  }
  return Triangulation(complex.dimension(), std::move(all));
}

namespace {

// All points whose lifted companions lie on the witness plane of the simplex; none if one of them
// lies below it.
Face points_on_supporting_plane(const PointSet& points, const Simplex& simplex) {
  Face cell;
  for (const Vertex q : all_vertices(points)) {
    const int below = contains(simplex, q) ? 0 : in_ball(points.configuration(), simplex, q);
    if (below > 0) return {};
    if (below == 0) cell.push_back(q);
  }
  return cell;
}

// The lifted companions S⁺, at the heights |p|² − w.
PointSet lifted(const PointSet& points) {
  std::vector<Point> companions = points.points();
  for (std::size_t v = 0; v < companions.size(); ++v) {
    const Rational height = squared_length(companions[v]) - points.weight(static_cast<Vertex>(v));
    companions[v].push_back(height);
  }
  return PointSet(std::move(companions));
}

// Does the facet of conv S⁺ face downwards? It does if it is not vertical and the others are above.
bool is_downward_facing(const PointSet& points, const PointSet& companions, const Face& facet) {
  const Simplex simplex = flat_through(companions, facet).basis;
  if (orientation(points.configuration(), simplex) == 0) return false;
  Vertex elsewhere = 0;
  while (std::binary_search(facet.begin(), facet.end(), elsewhere)) ++elsewhere;
  return in_ball(points.configuration(), simplex, elsewhere) < 0;
}

}  // namespace

PolyhedralComplex delaunay_subdivision_by_definition(const PointSet& points) {
  const int k = points.dimension();
  std::set<Face> cells;
  if (points.empty()) return PolyhedralComplex(points, k, {}, facets_by_definition);
  Simplex subset = first_subset(static_cast<std::size_t>(k) + 1);
  do {
    if (orientation(points.configuration(), subset) == 0) continue;
    const Face cell = points_on_supporting_plane(points, subset);
    if (!cell.empty()) cells.insert(cell);
  } while (next_subset(subset, points.size()));
  return PolyhedralComplex(points, k, {cells.begin(), cells.end()}, facets_by_definition);
}

PolyhedralComplex delaunay_subdivision(const PointSet& points, const HullWatch& watch) {
  const int k = points.dimension();
  if (points.empty()) return PolyhedralComplex(points, k, {}, facets_by_wrapping);
  const PointSet companions = lifted(points);
  const Face all = all_vertices(points);
  std::vector<Face> cells;
  if (companions.dimension() == k) {
    cells.push_back(all);  // all lifted points lie on one hyperplane: a single cell
    if (watch) watch(all, true);
  } else {
    for (const Face& facet : facets_by_wrapping(companions, all)) {
      const bool is_lower = is_downward_facing(points, companions, facet);
      if (watch) watch(facet, is_lower);
      if (is_lower) cells.push_back(facet);
    }
  }
  return PolyhedralComplex(points, k, std::move(cells), facets_by_wrapping);
}

Triangulation lifted_hull_by_definition(const PointSet& points) {
  return least_vertex_triangulation(points, delaunay_subdivision_by_definition(points));
}

Triangulation lifted_hull(const PointSet& points, const HullWatch& watch) {
  return least_vertex_triangulation(points, delaunay_subdivision(points, watch));
}

}  // namespace circumspect::delaunay
