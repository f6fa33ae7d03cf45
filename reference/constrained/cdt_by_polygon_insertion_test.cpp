// CDTs by polygon insertion, carved to the domain; and polygons deleted. Book: Sections 5.6 and 5.8.
#include "reference/constrained/cdt_by_polygon_insertion.hpp"

#include <doctest/doctest.h>

#include "properties/generators/named_complexes.hpp"
#include "reference/constrained/carve.hpp"
#include "reference/constrained/delete_polygon.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"

namespace circumspect::constrained {
namespace {

using generators::both;
using generators::box;

PlcTriangulation made(const PiecewiseLinearInput& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  PolygonInsertionOptions options;
  const auto by_flips = cdt_by_polygon_insertion(complex, options);
  REQUIRE(by_flips.has_value());
  options.by = PolygonInsertion::kCavities;
  CHECK(cdt_by_polygon_insertion(complex, options).value() == *by_flips);
  CHECK(gift_wrapping_cdt(complex).value() == *by_flips);
  return *by_flips;
}

TEST_CASE("a box, a box within a box, and the same as a cavity") {
  const std::size_t tetrahedra = made(box(0, 1)).simplices.size();
  CHECK(tetrahedra == 6);
  CHECK(made(box(0, 1)).dangling.empty());
  PiecewiseLinearInput nested = both(box(0, 12), box(4, 8));
  const PlcTriangulation whole = made(nested);
  nested.hole_seeds = {{5, 6, 7}};
  const PlcTriangulation hollow = made(nested);
  CHECK(hollow.simplices.size() == whole.simplices.size() - 6);
  CHECK(hollow.dangling.empty());
}

TEST_CASE("what dangles, inside and outside") {
  PiecewiseLinearInput input = box(0, 4);
  input.points.insert(input.points.end(), {{1, 1, 2},
                                           {3, 1, 2},
                                           {2, 3, 2},
                                           {9, 0, 0},
                                           {9, 1, 0},
                                           {9, 0, 1},
                                           {-2, 0, 0},
                                           {-2, 0, 1},
                                           {-3, 3, 3}});
  input.polygons.push_back({{{8, 9, 10}}, {}});
  input.polygons.push_back({{{11, 12, 13}}, {}});
  input.segments.push_back({14, 15});
  const PlcTriangulation cdt = made(input);
  CHECK(cdt.dangling == std::vector<Simplex>{{11, 12, 13}, {14, 15}, {16}});
}

TEST_CASE("polygons that enclose nothing, and polygons in one plane with all the rest") {
  PiecewiseLinearInput open = box(0, 1);
  open.polygons.pop_back();
  CHECK(made(open).simplices.empty());
  CHECK(made(open).dangling.size() == 10);

  PiecewiseLinearInput flat{
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {5, 5, 0}}, {}, {}, {}, {}};
  flat.polygons = {{{{0, 1, 2, 3}}, {}}};
  CHECK(made(flat).simplices.empty());
  CHECK(made(flat).dangling.size() == 3);
}

TEST_CASE("a segment that is no Delaunay edge is named (Figure 4.10)") {
  const auto failed = cdt_by_polygon_insertion(assemble(generators::schonhardt()));
  REQUIRE(!failed.has_value());
  CHECK(failed.error().obstruction.obstacle == Obstacle::kSegmentMissing);
  CHECK(!failed.error().polygon.has_value());
}

TEST_CASE("without its polygon the CDT is Delaunay again") {
  PiecewiseLinearInput input{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}},
                             {},
                             {{{{0, 1, 2}}, {}}},
                             {},
                             DomainKind::kHull};
  const PiecewiseLinearComplex complex = assemble(input);
  EvolvingCdt cdt = hull_cdt_by_polygon_insertion(complex).value();
  CHECK(cdt == evolving_cdt(complex, carve(complex, cdt)));
  CHECK(cdt.tetrahedra.size() == 2);
  CHECK(!delete_polygon(complex.points, cdt, complex.polygons.front()));
  CHECK(cdt.walls.empty());
  CHECK(cdt.tetrahedra.simplices() == evolving_delaunay(complex.points).tetrahedra.simplices());
}

}  // namespace
}  // namespace circumspect::constrained
