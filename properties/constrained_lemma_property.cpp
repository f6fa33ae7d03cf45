// C1: the Constrained Delaunay Lemma on arbitrary triangulations of complexes, with real
// visibility. Book: Lemma 4.10; Proposition 4.12; Definition 4.7 for dangling triangles.
#include <algorithm>

#include <doctest/doctest.h>

#include "properties/arguments/complexes.hpp"
#include "properties/arguments/run.hpp"
#include "properties/constrained_delaunay.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/existence/matching.hpp"

namespace circumspect::properties {
namespace {

using generators::ComplexCase;
using generators::Complexes;

Complexes complexes_to_enumerate() {
  return rc::gen::oneOf(generators::any_complex(7), any_protected_complex(8));
}

// "Let P be a PLC in which every linear cell is a face of some polyhedron in P, so there are no
// dangling polygons." What lies on a wall outside of every polyhedron plays no part in the three
// statements, which are about tetrahedra and their facets; so complexes that have such cells are in
// as well.
TEST_CASE("C1 the Constrained Delaunay Lemma: (i) iff (ii) iff (iii) (Lemma 4.10)") {
  std::size_t constrained_delaunay = 0, others = 0;
  CHECK(holds("three statements about a triangulation", 120, [&] {
    const ComplexCase one = *complexes_to_enumerate();
    const PiecewiseLinearComplex complex = one.complex();
    RC_PRE(complex.points.dimension() == 3);
    const Regions regions(complex);
    const auto candidates = existence::respecting_tetrahedra(complex, regions);
    for (const auto& tetrahedra : plc_triangulations(complex, regions, candidates, 12)) {
      const bool third = free_facets_are_locally_delaunay(complex, regions, tetrahedra);
      RC_ASSERT(tetrahedra_are_constrained_delaunay(complex, regions, tetrahedra) == third);
      RC_ASSERT(free_facets_are_constrained_delaunay(complex, regions, tetrahedra) == third);
      if (!tetrahedra.empty()) ++(third ? constrained_delaunay : others);
    }
  }));
  CHECK(occurs(constrained_delaunay));
  CHECK(occurs(others));
  MESSAGE(constrained_delaunay << " CDTs, " << others << " others");
}

TEST_CASE("C1 the CDTs are the triangulations of constrained Delaunay tetrahedra; C3 at most one") {
  std::size_t several = 0;
  CHECK(holds("any_cdt's candidates", 100, [&] {
    const ComplexCase one = *complexes_to_enumerate();
    const PiecewiseLinearComplex complex = one.complex();
    RC_PRE(complex.points.dimension() == 3);
    const Regions regions(complex);
    const auto candidates = existence::constrained_delaunay_tetrahedra(complex, regions);
    const auto cdts = plc_triangulations(complex, regions, candidates, 20);
    for (const auto& tetrahedra : cdts) {
      RC_ASSERT(free_facets_are_locally_delaunay(complex, regions, tetrahedra));
    }
    if (cdts.size() > 1) ++several;
    // Proposition 4.12, "A generic piecewise linear complex has at most one".
    if (cdts.size() > 1) RC_ASSERT(delaunay::cospherical_points(complex.points).has_value());
    // The canonical CDT is the only one of the perturbed complex, and one of these.
    const auto canonical = constrained::gift_wrapping_cdt(complex);
    if (!canonical) return;
    const bool is_there = std::binary_search(cdts.begin(), cdts.end(), canonical->simplices);
    RC_ASSERT(is_there || cdts.size() == 20);
  }));
  CHECK(occurs(several));
}

// Is every edge that is not a segment locally Delaunay in the polygon's plane?
bool is_planar_cdt(const PointSet& points, const Polygon& polygon,
                   const std::vector<Simplex>& triangles) {
  const StarIndex index(triangles);
  for (const Simplex& edge : facets_of(triangles)) {
    if (std::binary_search(polygon.segments.begin(), polygon.segments.end(), edge)) continue;
    if (!is_locally_delaunay(points, index.star(edge), edge)) return false;
  }
  return true;
}

TEST_CASE("C1 dangling triangles are constrained Delaunay iff theirs is a planar CDT (Def. 4.7)") {
  std::size_t cdts = 0, others = 0;
  CHECK(holds("a dangling polygon", 150, [&] {
    ComplexCase one = *generators::flat_cells(12);
    one.input.kind = DomainKind::kEnclosed;
    const PiecewiseLinearComplex complex = one.complex();
    const Regions regions(complex);
    RC_PRE(regions.size() == 1u);  // nothing is enclosed: all polygons dangle
    for (const Polygon& polygon : complex.polygons) {
      const auto triangles = any_triangulation_of(complex.points, polygon);
      const bool all =
          std::all_of(triangles.begin(), triangles.end(), [&](const Simplex& triangle) {
            return is_constrained_delaunay(complex, regions, triangle);
          });
      RC_ASSERT(all == is_planar_cdt(complex.points, polygon, triangles));
      if (triangles.size() > 1) ++(all ? cdts : others);
      const auto own = constrained::planar_cdt(complex.points, polygon);
      RC_ASSERT(is_planar_cdt(complex.points, polygon, own));
    }
  }));
  CHECK(occurs(cdts));
  CHECK(occurs(others));
}

// "If the interior of a segment intersects the interior of a polygon, the segment is entirely
// included in the polygon." (Exercise 1 of Chapter 4)
TEST_CASE("C1 a segment whose interior meets a polygon's is included in it (Exercise 1)") {
  std::size_t included = 0, kept_out = 0;
  CHECK(holds("segments and polygons", 150, [&] {
    const ComplexCase one = *generators::any_complex(10);
    const PiecewiseLinearComplex complex = one.complex();
    for (const Polygon& polygon : complex.polygons) {
      for (const Simplex& segment : complex.segments) {
        const std::vector<Point> ends = coordinates(complex.points, segment);
        // Somewhere strictly between its ends, and not only in an edge of the outline.
        bool meets = false;
        for (const Simplex& triangle : polygon.triangles) {
          const auto common = intersection(ends, coordinates(complex.points, triangle));
          const bool inside = std::any_of(common.begin(), common.end(), [&](const Point& p) {
            return p != ends[0] && p != ends[1];
          });
          meets = meets || inside || common.size() == 2;
        }
        const bool is_face =
            std::binary_search(polygon.segments.begin(), polygon.segments.end(), segment);
        RC_ASSERT(meets == is_face);
        ++(meets ? included : kept_out);
      }
    }
  }));
  CHECK(occurs(included));
  CHECK(occurs(kept_out));
}

}  // namespace
}  // namespace circumspect::properties
