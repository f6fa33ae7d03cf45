// C5: what a CDT minimises among all triangulations of the complex. Book: Proposition 4.13, with
// Propositions 4.5 to 4.8.
#include <doctest/doctest.h>

#include "properties/arguments/complexes.hpp"
#include "properties/arguments/run.hpp"
#include "properties/constrained_delaunay.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/existence/matching.hpp"
#include "reference/optimality/criteria.hpp"

namespace circumspect::properties {
namespace {

// Barycentres of all tetrahedra, facets and edges of a triangulation.
std::vector<Point> sample_points(const PointSet& points, const std::vector<Simplex>& tetrahedra) {
  std::vector<Point> samples;
  const std::vector<Simplex> facets = facets_of(tetrahedra);
  for (const auto& simplices : {tetrahedra, facets, facets_of(facets)}) {
    for (const Simplex& simplex : simplices) samples.push_back(barycentre(points, simplex));
  }
  return samples;
}

TEST_CASE("C5 CDTs are best among the triangulations of the complex (Proposition 4.13)") {
  std::size_t not_delaunay = 0, others = 0;
  CHECK(holds("min-containment ball, interpolation error", 80, [&] {
    const generators::ComplexCase one =
        *rc::gen::oneOf(any_protected_complex(8), generators::any_complex(7));
    const PiecewiseLinearComplex complex = one.complex();
    const PointSet& points = complex.points;
    RC_PRE(points.dimension() == 3);
    const Regions regions(complex);
    const auto cdts = plc_triangulations(
        complex, regions, existence::constrained_delaunay_tetrahedra(complex, regions), 1);
    if (cdts.empty() || cdts.front().empty()) return;
    const Triangulation best(3, cdts.front());
    if (!are_delaunay(points, best.simplices())) ++not_delaunay;
    const Rational least = optimality::largest_min_containment_ball(points, best).squared_radius;
    const Rational least_error = optimality::greatest_interpolation_error(points, best).error;
    const Rational least_integral = optimality::lifted_integral(points, best);
    RC_ASSERT(least == least_error);
    const std::vector<Point> samples = sample_points(points, best.simplices());
    for (const auto& tetrahedra : plc_triangulations(
             complex, regions, existence::respecting_tetrahedra(complex, regions), 25)) {
      const Triangulation another(3, tetrahedra);
      const bool is_cdt = free_facets_are_locally_delaunay(complex, regions, tetrahedra);
      const Rational radius =
          optimality::largest_min_containment_ball(points, another).squared_radius;
      const Rational integral = optimality::lifted_integral(points, another);
      RC_ASSERT((is_cdt ? radius == least : radius >= least));
      RC_ASSERT(optimality::greatest_interpolation_error(points, another).error == radius);
      RC_ASSERT((is_cdt ? integral == least_integral : integral > least_integral));
      for (const Point& p : samples) {
        const Rational height = *optimality::lifted_height(points, another, p);
        const Rational least_height = *optimality::lifted_height(points, best, p);
        RC_ASSERT((is_cdt ? height == least_height : height >= least_height));
      }
      if (!is_cdt) ++others;
    }
  }));
  CHECK(occurs(not_delaunay));
  CHECK(occurs(others));
  MESSAGE(not_delaunay << " CDTs that are not Delaunay, " << others << " other triangulations");
}

}  // namespace
}  // namespace circumspect::properties
