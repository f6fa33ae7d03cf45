// Filling cavities. Book: Section 5.8.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"

namespace circumspect::constrained {
namespace {

const std::vector<std::size_t> kSpace = {0, 1, 2};

TEST_CASE("deleted tetrahedra of a Delaunay triangulation come back") {
  const PointSet points({{0, 0, 0}, {7, 0, 1}, {1, 8, 0}, {0, 1, 9}, {2, 3, 2}, {5, 5, 4}});
  const EvolvingCdt cdt = evolving_delaunay(points);
  const std::vector<Simplex> all(cdt.tetrahedra.simplices().begin(),
                                 cdt.tetrahedra.simplices().end());
  CHECK(gift_wrap_cavity(points, cavity_of(points, kSpace, {}, all)).value() == all);
}

TEST_CASE("a wall in a square stays, on both sides") {
  const PointSet points({{0, 0}, {4, 1}, {5, 5}, {1, 4}});
  // Delaunay is the edge 1 3; the wall 0 2 forbids it.
  const std::vector<Simplex> cut = {{0, 1, 2}, {0, 2, 3}}, delaunay = {{0, 1, 3}, {1, 2, 3}};
  const std::vector<std::size_t> plane = {0, 1};
  CHECK(gift_wrap_cavity(points, cavity_of(points, plane, {}, cut)).value() == delaunay);
  CHECK(gift_wrap_cavity(points, cavity_of(points, plane, {{0, 2}}, cut)).value() == cut);
}

TEST_CASE("Schönhardt's polyhedron has a facet that cannot be finished (Figure 4.10)") {
  // The triangle above is turned by 30 degrees, or nearly.
  const PointSet points(
      {{10, 0, 0}, {-5, 9, 0}, {-5, -9, 0}, {9, 5, 10}, {-9, 5, 10}, {0, -10, 10}});
  Cavity cavity;
  cavity.axes = kSpace;
  cavity.candidates = {0, 1, 2, 3, 4, 5};
  // The reflex diagonal of each quadrilateral between.
  for (const Simplex& facet : {Simplex{0, 1, 2},
                               {3, 4, 5},
                               {0, 1, 4},
                               {0, 3, 4},
                               {1, 2, 5},
                               {1, 4, 5},
                               {0, 2, 3},
                               {2, 3, 5}}) {
    // The inside of each is where most other vertices are: the middle (0, 0, 5) is in front.
    OrientedFacet inward = OrientedFacet::of(facet);
    std::vector<Point> with_middle = points.points();
    with_middle.push_back({0, 0, 5});
    const PointSet more(with_middle);
    if (orientation(more.configuration(), join(inward, 6)) < 0) inward = inward.reverse();
    cavity.facets.add(inward);
  }
  const auto wrapped = gift_wrap_cavity(points, cavity);
  REQUIRE(!wrapped.has_value());
  CHECK(wrapped.error().why == WhyNoChange::kFacetUnfinished);
}

}  // namespace
}  // namespace circumspect::constrained
