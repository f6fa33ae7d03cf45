// C3: edge-protected complexes have one CDT, and three constructions find it; elsewhere gift-
// wrapping decides whether there is one. Book: Proposition 4.12, Sections 5.6 and 5.8.
#include <map>
#include <numeric>
#include <string>

#include <doctest/doctest.h>

#include "properties/arguments/complexes.hpp"
#include "properties/arguments/run.hpp"
#include "properties/constrained_delaunay.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/existence/existence.hpp"

namespace circumspect::properties {
namespace {

using constrained::cdt_by_polygon_insertion;
using constrained::gift_wrapping_cdt;
using constrained::PlcTriangulation;
using constrained::PolygonInsertion;
using generators::ComplexCase;

std::vector<std::size_t> random_order(std::size_t size) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = size; i > 1; --i) {
    std::swap(order[i - 1], order[*rc::gen::inRange<std::size_t>(0, i)]);
  }
  return order;
}

// By flips and by cavities, the polygons in a random order and in the reverse of that.
void insertions_agree(const PiecewiseLinearComplex& complex, const PlcTriangulation& expected) {
  const std::vector<std::size_t> order = random_order(complex.polygons.size());
  for (const PolygonInsertion by : {PolygonInsertion::kFlips, PolygonInsertion::kCavities}) {
    for (const auto& one : {order, std::vector<std::size_t>(order.rbegin(), order.rend())}) {
      const auto found = cdt_by_polygon_insertion(complex, {by, one});
      RC_ASSERT(found.has_value());
      RC_ASSERT(*found == expected);
    }
  }
}

TEST_CASE("C3 three constructions find the one CDT of edge-protected complexes (Prop. 4.12)") {
  std::size_t not_delaunay = 0;
  CHECK(holds("gift-wrapping, flips, cavities", 500, [&] {
    const ComplexCase one = *any_protected_complex(14);
    const PiecewiseLinearComplex complex = one.complex();
    const auto cdt = gift_wrapping_cdt(complex);
    RC_ASSERT(cdt.has_value());
    insertions_agree(complex, *cdt);
    if (!are_delaunay(complex.points, cdt->simplices)) ++not_delaunay;
  }));
  CHECK(occurs(not_delaunay));
  MESSAGE(not_delaunay << " with tetrahedra that are not Delaunay");
}

TEST_CASE("C3 elsewhere gift-wrapping decides, and the others agree or cannot tell (Section 5.6)") {
  std::map<std::string, std::size_t> answers;
  CHECK(holds("has it a CDT?", 150, [&] {
    const ComplexCase one = *generators::any_complex(8);
    const PiecewiseLinearComplex complex = one.complex();
    const Regions regions(complex);
    const auto cdt = gift_wrapping_cdt(complex);
    for (const PolygonInsertion by : {PolygonInsertion::kFlips, PolygonInsertion::kCavities}) {
      const auto order = random_order(complex.polygons.size());
      const auto found = cdt_by_polygon_insertion(complex, {by, order});
      if (found) {
        RC_ASSERT(cdt.has_value());
        RC_ASSERT(*found == *cdt);
      }
      ++answers[cdt ? found ? "yes" : "yes, not by insertion" : "no"];
    }
    if (complex.points.dimension() < 3) return;
    // Independently: some constrained Delaunay tetrahedra fill the domain or not. The canonical CDT
    // is one without perturbation as well; a generic complex has no other.
    const auto any = existence::any_cdt(complex, regions);
    if (cdt) {
      RC_ASSERT(std::holds_alternative<existence::Exists>(any));
    } else if (!delaunay::cospherical_points(complex.points)) {
      RC_ASSERT(std::holds_alternative<existence::Impossible>(any));
      ++answers["no, generic"];
    } else if (std::holds_alternative<existence::Exists>(any)) {
      ++answers["no, but another"];
    }
    const auto triangulation = existence::any_triangulation(complex, regions);
    if (std::holds_alternative<existence::Impossible>(triangulation)) {
      RC_ASSERT(!cdt.has_value());
      ++answers["no triangulation"];
    }
  }));
  for (const char* answer : {"yes", "no", "no, generic", "no triangulation"}) {
    CAPTURE(std::string(answer));
    CHECK(occurs(answers[answer]));
  }
  for (const auto& [answer, often] : answers) MESSAGE(answer << ": " << often);
}

}  // namespace
}  // namespace circumspect::properties
