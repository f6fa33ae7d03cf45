// C2: edge-protected complexes have CDTs; C4: what a CDT induces on each polygon is the polygon's
// own. Book: Section 4.5.3, Theorem 4.9 (the CDT Theorem); Proposition 4.11 (Exercise 4 of Chapter
// 4).
#include <algorithm>
#include <map>

#include <doctest/doctest.h>

#include "properties/arguments/complexes.hpp"
#include "properties/arguments/run.hpp"
#include "properties/constrained_delaunay.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"

namespace circumspect::properties {
namespace {

using constrained::gift_wrapping_cdt;
using constrained::PlcTriangulation;
using generators::ComplexCase;

// The triangles of a triangulation that a polygon includes.
std::vector<Simplex> induced(const PiecewiseLinearComplex& complex, const Polygon& polygon,
                             const PlcTriangulation& triangulation) {
  std::vector<Simplex> triangles = facets_of(triangulation.simplices);
  for (const Simplex& simplex : triangulation.dangling) {
    if (simplex.size() == 3) triangles.push_back(simplex);
  }
  std::sort(triangles.begin(), triangles.end());
  std::erase_if(triangles, [&](const Simplex& triangle) {
    return !is_included(complex.points, triangle, polygon);
  });
  return triangles;
}

TEST_CASE("C2 edge-protected complexes have CDTs, in both readings (Theorem 4.9)") {
  std::map<bool, std::size_t> strongly;
  CHECK(holds("passes the definition", 200, [&] {
    const ComplexCase one = *any_protected_complex(9);
    const PiecewiseLinearComplex complex = one.complex();
    const Regions regions(complex);
    ++strongly[constrained::is_edge_protected(complex)];
    RC_ASSERT(constrained::is_edge_protected_under_perturbation(complex));
    const auto cdt = gift_wrapping_cdt(complex);
    RC_ASSERT(cdt.has_value());
    for (const Simplex& tetrahedron : cdt->simplices) {
      RC_ASSERT(respects(complex, regions, tetrahedron));
      RC_ASSERT(is_constrained_delaunay(complex, regions, tetrahedron));
    }
    for (const Simplex& simplex : cdt->dangling) {
      if (simplex.size() != 3) continue;
      RC_ASSERT(respects(complex, regions, simplex));
      RC_ASSERT(is_constrained_delaunay(complex, regions, simplex));
    }
  }));
  CHECK(occurs(strongly[true]));
  CHECK(occurs(strongly[false]));
}

TEST_CASE("C4 a CDT induces on every polygon its own planar CDT (Proposition 4.11)") {
  std::size_t polygons = 0;
  CHECK(holds("both planar algorithms", 300, [&] {
    const ComplexCase one = *rc::gen::oneOf(any_protected_complex(11), generators::any_complex(9));
    const PiecewiseLinearComplex complex = one.complex();
    const auto cdt = gift_wrapping_cdt(complex);
    if (!cdt) return;
    for (const Polygon& polygon : complex.polygons) {
      const std::vector<Simplex> triangles = induced(complex, polygon, *cdt);
      RC_ASSERT(triangles == constrained::planar_cdt(complex.points, polygon));
      RC_ASSERT(triangles ==
                constrained::planar_cdt(complex.points, polygon,
                                        constrained::PlanarAlgorithm::kSegmentInsertion));
      if (triangles.size() > 1) ++polygons;
    }
  }));
  CHECK(occurs(polygons));
}

}  // namespace
}  // namespace circumspect::properties
