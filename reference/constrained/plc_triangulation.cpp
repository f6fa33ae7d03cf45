#include "reference/constrained/plc_triangulation.hpp"

#include <algorithm>
#include <iterator>

#include "kernel/complex/point_set.hpp"

namespace circumspect::constrained {
namespace {

// Twelve numbers give four points; the sign of their determinant.
int orientation_of(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sign(inner_product(a - d, cross_product(b - d, c - d)));
}

// The tetrahedra from which nothing of the domain can be reached.
std::set<Simplex> tetrahedra_without(const PiecewiseLinearComplex& complex,
                                     const EvolvingCdt& cdt) {
  std::set<Simplex> out;
  if (complex.kind == DomainKind::kHull) return out;  // The hull kind has no holes.
  std::vector<Simplex> pending;
  const auto flood = [&](const Simplex& tetrahedron) {
    if (out.insert(tetrahedron).second) pending.push_back(tetrahedron);
  };
  for (const Simplex& tetrahedron : cdt.tetrahedra.simplices()) {
    for (const Point& seed : complex.hole_seeds) {
      if (holds(complex.points, tetrahedron, seed)) flood(tetrahedron);
    }
    for (const Simplex& facet : facets_of({tetrahedron})) {
      if (!cdt.walls.contains(facet) && cdt.tetrahedra.star(facet).size() == 1) flood(tetrahedron);
    }
  }
  while (!pending.empty()) {
    const Simplex tetrahedron = pending.back();
    pending.pop_back();
    for (const Simplex& facet : facets_of({tetrahedron})) {
      if (cdt.walls.contains(facet)) continue;
      for (const Simplex& side : cdt.tetrahedra.star(facet)) flood(side);
    }
  }
  return out;
}

}  // namespace

bool holds(const PointSet& points, const Simplex& tetrahedron, const Point& point) {
  const std::vector<Point> corners = coordinates(points, tetrahedron);
  const int own = orientation_of(corners[0], corners[1], corners[2], corners[3]);
  for (std::size_t place = 0; place < corners.size(); ++place) {
    std::vector<Point> replaced = corners;
    replaced[place] = point;
    if (own * orientation_of(replaced[0], replaced[1], replaced[2], replaced[3]) < 0) return false;
  }
  return true;
}

PlcTriangulation with_dangling(std::vector<Simplex> simplices, const std::set<Simplex>& faces) {
  std::sort(simplices.begin(), simplices.end());
  std::vector<Simplex> by_dimension(faces.begin(), faces.end());
  std::stable_sort(by_dimension.begin(), by_dimension.end(),
                   [](const Simplex& a, const Simplex& b) { return a.size() > b.size(); });
  StarIndex all(simplices);
  PlcTriangulation triangulation{std::move(simplices), {}};
  for (const Simplex& face : by_dimension) {
    if (!all.star(face).empty()) continue;
    all.replace({}, {face});
    triangulation.dangling.push_back(face);
  }
  std::sort(triangulation.dangling.begin(), triangulation.dangling.end());
  return triangulation;
}

PlcTriangulation carve(const PiecewiseLinearComplex& complex, const EvolvingCdt& cdt) {
  const std::set<Simplex> out = tetrahedra_without(complex, cdt);
  std::vector<Simplex> inside;
  std::set_difference(cdt.tetrahedra.simplices().begin(), cdt.tetrahedra.simplices().end(),
                      out.begin(), out.end(), std::back_inserter(inside));
  std::set<Simplex> faces = cdt.walls;
  faces.insert(cdt.segments.begin(), cdt.segments.end());
  for (const Vertex v : all_vertices(complex.points)) faces.insert({v});
  return with_dangling(std::move(inside), faces);
}

}  // namespace circumspect::constrained
