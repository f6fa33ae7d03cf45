// C1, C3: gift-wrapping finds the constrained Delaunay tetrahedra of the definition, all of them
// and no other; where it says that there is no CDT, these do not fill the domain. No construction
// is held against another here. Book: Definition 4.6, Proposition 4.12, Section 5.6.
#include <algorithm>
#include <map>
#include <string>

#include <doctest/doctest.h>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using constrained::gift_wrapping_cdt;

const std::vector<std::size_t> kSpace = {0, 1, 2};

// Definition 4.6 under the canonical perturbation.
bool is_constrained_delaunay_perturbed(const PiecewiseLinearComplex& complex,
                                       const Regions& regions, const Simplex& tetrahedron) {
  const Configuration& points = complex.points.configuration();
  if (orientation(points, kSpace, tetrahedron) == 0) return false;
  if (!respects(complex, regions, tetrahedron)) return false;
  const std::vector<Vertex> all = all_vertices(complex.points);
  return std::none_of(all.begin(), all.end(), [&](Vertex v) {
    return !contains(tetrahedron, v) && perturbed_in_ball(points, kSpace, tetrahedron, v) > 0 &&
           is_visible(complex, regions, v, tetrahedron);
  });
}

std::vector<Simplex> all_constrained_delaunay(const PiecewiseLinearComplex& complex) {
  const Regions regions(complex);
  std::vector<Simplex> found;
  if (complex.points.size() < 4) return found;
  Simplex tetrahedron = first_subset(4);
  do {
    if (is_constrained_delaunay_perturbed(complex, regions, tetrahedron))
      found.push_back(tetrahedron);
  } while (next_subset(tetrahedron, complex.points.size()));
  return found;
}

Rational volume_of_tetrahedra(const PointSet& points, const std::vector<Simplex>& tetrahedra) {
  Rational sum = 0;
  for (const Simplex& tetrahedron : tetrahedra) {
    const Rational part = orientation_determinant(points.configuration(), kSpace, tetrahedron);
    sum += sign(part) * part;
  }
  return sum;
}

// The volume of |P|, as of `volume`: of the convex hull, or what the inner sides of the walls
// enclose.
Rational volume_of_tetrahedra(const PiecewiseLinearComplex& complex) {
  const PointSet& points = complex.points;
  if (complex.kind == DomainKind::kHull) {
    if (points.dimension() < 3) return 0;
    return volume_of_tetrahedra(points, delaunay::by_definition(points).simplices());
  }
  const Regions regions(complex);
  Rational sum = 0;
  for (const Simplex& wall : walls(complex)) {
    const OrientedFacet facet = OrientedFacet::of(wall);
    for (const OrientedFacet& side : {facet, facet.reverse()}) {
      if (!regions.faces_inside(side)) continue;
      // Joined to vertex 0, with a sign: inner sides have it in front if the domain is there.
      if (contains(wall, 0)) continue;
      sum += orientation_determinant(points.configuration(), kSpace, join(side, 0));
    }
  }
  return sum;
}

std::string reason(constrained::WhyNoCdt why) {
  switch (why) {
    case constrained::WhyNoCdt::kFacetUnfinished:
      return "unfinished";
    case constrained::WhyNoCdt::kPolygonCrosses:
      return "polygon";
    case constrained::WhyNoCdt::kSegmentCrosses:
      return "crossed";
    case constrained::WhyNoCdt::kSimplicesOverlap:
      return "overlap";
    case constrained::WhyNoCdt::kNotLocallyDelaunay:
      return "not local";
    default:
      return "missing";
  }
}

TEST_CASE("C1 C3 gift-wrapping finds the constrained Delaunay tetrahedra, or they leave a gap") {
  std::map<std::string, std::size_t> answers;
  CHECK(holds("gift-wrapping a CDT: against Definition 4.6", 80, [&] {
    const PiecewiseLinearComplex complex = (*generators::any_complex(9)).complex();
    const std::vector<Simplex> expected = all_constrained_delaunay(complex);
    const auto cdt = gift_wrapping_cdt(complex);
    ++answers[cdt ? cdt->simplices.empty() ? "flat" : "CDT" : reason(cdt.error().why)];
    const bool fills =
        volume_of_tetrahedra(complex.points, expected) == volume_of_tetrahedra(complex);
    RC_ASSERT(cdt.has_value() == fills);
    if (cdt) RC_ASSERT(cdt->simplices == expected);
  }));
  CHECK(occurs(answers["CDT"]));
  CHECK(occurs(answers["unfinished"] + answers["polygon"] + answers["crossed"] +
               answers["overlap"] + answers["not local"]));
  for (const auto& [answer, often] : answers) MESSAGE(answer << ": " << often);
}

TEST_CASE("C1 C3 gift-wrapping makes a simplicial complex that holds every cell (Definition 4.4)") {
  CHECK(holds("gift-wrapping a CDT: Definition 4.4", 60, [] {
    const PiecewiseLinearComplex complex = (*generators::any_complex(9)).complex();
    const auto cdt = gift_wrapping_cdt(complex);
    if (!cdt) return;
    const std::vector<Simplex> all = cdt->simplices_and_dangling();
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        RC_ASSERT_FALSE(improper_intersection(complex.points, all[i], all[j]).has_value());
      }
    }
    std::vector<Simplex> cells = constrained::triangulated_polygons(complex);
    cells.insert(cells.end(), complex.segments.begin(), complex.segments.end());
    for (const Vertex v : all_vertices(complex.points)) cells.push_back({v});
    for (const Simplex& cell : cells) {
      RC_ASSERT(std::any_of(all.begin(), all.end(), [&](const Simplex& simplex) {
        return std::includes(simplex.begin(), simplex.end(), cell.begin(), cell.end());
      }));
    }
  }));
}

}  // namespace
}  // namespace circumspect::properties
