// Triangulations of polygons and of complexes, all of them, and which are constrained Delaunay,
// by definition.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/generated.hpp"
#include "reference/existence/matching.hpp"
#include "reference/existence/solver.hpp"

namespace circumspect::properties {

// All triangulations of a small complex, CDTs or not. Book: Definition 4.4.

// Triangulations of the polyhedra of a complex that consist of some of the candidates, each with
// its tetrahedra ascending, in no particular order: all of them, or as many as `limit`. Each is a
// solution of the formula; a clause that forbids it lets the solver find the next. Requires: every
// candidate respects the complex.
inline std::vector<std::vector<Simplex>> plc_triangulations(const PiecewiseLinearComplex& complex,
                                                            const Regions& regions,
                                                            const std::vector<Simplex>& candidates,
                                                            std::size_t limit) {
  existence::Formula formula = existence::matching_formula(complex, regions, candidates);
  std::vector<std::vector<Simplex>> all;
  while (all.size() < limit) {
    const auto answer = existence::solve(formula);
    const auto* satisfied = std::get_if<existence::Satisfied>(&answer);
    if (satisfied == nullptr) break;
    std::vector<Simplex> tetrahedra;
    existence::Clause another;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!satisfied->assignment[i]) continue;
      tetrahedra.push_back(candidates[i]);
      another.push_back(-static_cast<existence::Literal>(i) - 1);
    }
    all.push_back(std::move(tetrahedra));
    formula.clauses.push_back(std::move(another));
  }
  std::sort(all.begin(), all.end());
  return all;
}

// Random triangulations of a polygon. Book: Section 4.5.1.

// Some triangulation of the polygon that has its segments for edges, Delaunay or not, after up to
// five random flips. Within a property or rc::gen::exec.
inline std::vector<Simplex> any_triangulation_of(const PointSet& points, const Polygon& polygon) {
  std::vector<Simplex> triangles = polygon.triangles;
  for (Simplex& triangle : triangles) triangle = sorted(triangle);
  StarIndex index(triangles);
  for (long i = *generators::below(6); i > 0; --i) {
    std::vector<Simplex> edges = facets_of({index.simplices().begin(), index.simplices().end()});
    std::erase_if(edges, [&](const Simplex& edge) {
      if (std::binary_search(polygon.segments.begin(), polygon.segments.end(), edge)) return true;
      const auto star = index.star(edge);
      const Vertex a = without(star[0], edge)[0], b = without(star[1], edge)[0];
      const int at_one_end =
          orientation(points.configuration(), polygon.axes, Simplex{a, b, edge[0]});
      const int at_other =
          orientation(points.configuration(), polygon.axes, Simplex{a, b, edge[1]});
      return at_one_end * at_other >= 0;
    });
    if (edges.empty()) break;
    const Simplex edge =
        edges[static_cast<std::size_t>(*generators::below(static_cast<long>(edges.size())))];
    const auto star = index.star(edge);
    const Simplex apexes = join(without(star[0], edge), without(star[1], edge));
    index.replace(star, {join(apexes, {edge[0]}), join(apexes, {edge[1]})});
  }
  return {index.simplices().begin(), index.simplices().end()};
}

// "Constrained Delaunay" and "locally Delaunay" from their definitions, with real visibility, for
// holding constructions and lemmas against them. Book: Definition 4.6, Lemma 4.10.

// Does the polygon include the triangle? Requires: the triangle respects a complex with the
// polygon.
inline bool is_included(const PointSet& points, const Simplex& triangle, const Polygon& polygon) {
  for (const Vertex v : triangle) {
    if (!std::binary_search(polygon.vertices.begin(), polygon.vertices.end(), v)) return false;
  }
  const Point centre = barycentre(points, triangle);
  return std::any_of(polygon.triangles.begin(), polygon.triangles.end(), [&](const Simplex& part) {
    return !intersection({centre}, coordinates(points, part)).empty();
  });
}

// Are all of them Delaunay, without regard to any complex?
inline bool are_delaunay(const PointSet& points, const std::vector<Simplex>& tetrahedra) {
  return std::all_of(tetrahedra.begin(), tetrahedra.end(), [&](const Simplex& tetrahedron) {
    const Ball ball = circumball(points, tetrahedron);
    for (Vertex v = 0; points.names(v); ++v) {
      if (sign(power(points, ball, v)) < 0) return false;
    }
    return true;
  });
}

// Definition 4.6 of a tetrahedron, triangle or edge that respects the complex: "there is an open
// circumball of σ that contains no vertex in P that is visible from any point in the relative
// interior of σ". The centre of a circumball of a triangle may move along a line: c + t·n, and
// power(v) = power at t = 0 − 2 t n·(v − c); each visible vertex bounds t.
// Requires: three or four vertices in space.
inline bool is_constrained_delaunay(const PiecewiseLinearComplex& complex, const Regions& regions,
                                    const Simplex& simplex) {
  const PointSet& points = complex.points;
  const Ball smallest = circumball(points, simplex);
  Point normal(3);
  if (simplex.size() == 3) {
    const Point& p = points[simplex[0]];
    normal = cross_product(points[simplex[1]] - p, points[simplex[2]] - p);
  }
  std::optional<Rational> least, greatest;  // of t
  for (Vertex v = 0; points.names(v); ++v) {
    if (contains(simplex, v)) continue;
    const Rational rest = power(points, smallest, v);
    const Rational slope = 2 * inner_product(normal, points[v] - smallest.centre);
    if (sign(slope) == 0 && sign(rest) >= 0) continue;
    if (!is_visible(complex, regions, v, simplex)) continue;
    if (sign(slope) == 0) return false;
    const Rational bound = rest / slope;
    if (sign(slope) > 0 && (!greatest || bound < *greatest)) greatest = bound;
    if (sign(slope) < 0 && (!least || bound > *least)) least = bound;
  }
  return !least || !greatest || *least <= *greatest;
}

// Is the facet of two tetrahedra locally Delaunay? "… if … it has an open circumball that contains
// neither apex": neither is in the open circumball of the other's tetrahedron.
inline bool is_locally_delaunay(const PointSet& points, const std::vector<Simplex>& star,
                                const Simplex& facet) {
  const Vertex apex = without(star[1], facet).front();
  return sign(power(points, circumball(points, star[0]), apex)) >= 0;
}

// The facets of a triangulation of the complex that no polygon includes, the hull's own facets
// being polygons of the hull kind.
inline std::vector<Simplex> free_facets(const PiecewiseLinearComplex& complex,
                                        const Regions& regions,
                                        const std::vector<Simplex>& tetrahedra) {
  const StarIndex index(tetrahedra);
  std::vector<Simplex> facets = facets_of(tetrahedra);
  std::erase_if(facets, [&](const Simplex& facet) {
    return index.star(facet).size() == 1 ||
           regions.locate(barycentre(complex.points, facet)) == Where::kOnWall;
  });
  return facets;
}

// Statements (i), (ii) and (iii) of the Constrained Delaunay Lemma.
inline bool tetrahedra_are_constrained_delaunay(const PiecewiseLinearComplex& complex,
                                                const Regions& regions,
                                                const std::vector<Simplex>& tetrahedra) {
  return std::all_of(tetrahedra.begin(), tetrahedra.end(), [&](const Simplex& tetrahedron) {
    return is_constrained_delaunay(complex, regions, tetrahedron);
  });
}
inline bool free_facets_are_constrained_delaunay(const PiecewiseLinearComplex& complex,
                                                 const Regions& regions,
                                                 const std::vector<Simplex>& tetrahedra) {
  const std::vector<Simplex> facets = free_facets(complex, regions, tetrahedra);
  return std::all_of(facets.begin(), facets.end(), [&](const Simplex& facet) {
    return is_constrained_delaunay(complex, regions, facet);
  });
}
inline bool free_facets_are_locally_delaunay(const PiecewiseLinearComplex& complex,
                                             const Regions& regions,
                                             const std::vector<Simplex>& tetrahedra) {
  const StarIndex index(tetrahedra);
  const std::vector<Simplex> facets = free_facets(complex, regions, tetrahedra);
  return std::all_of(facets.begin(), facets.end(), [&](const Simplex& facet) {
    return is_locally_delaunay(complex.points, index.star(facet), facet);
  });
}

}  // namespace circumspect::properties
