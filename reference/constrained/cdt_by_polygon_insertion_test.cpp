// CDTs by polygon insertion, carved to the domain; and polygons deleted. Book: Section 5.8.
#include "reference/constrained/cdt_by_polygon_insertion.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"

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

TEST_CASE("a domain that is not convex is carved from its hull") {
  // A prism over an L; the tetrahedra in the notch go.
  PiecewiseLinearInput input;
  for (const long z : {0, 4}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, std::pair{0, 8}}) {
      input.points.push_back({x, y, z});
    }
  }
  input.polygons = {{{{0, 1, 2, 3, 4, 5}}, {}}, {{{6, 7, 8, 9, 10, 11}}, {}}};
  for (Vertex v = 0; v < 6; ++v) {
    const Vertex w = (v + 1) % 6;
    input.polygons.push_back({{{v, w, w + 6, v + 6}}, {}});
  }
  const PlcTriangulation carved = made(input);
  CHECK(carved.dangling.empty());
  input.kind = DomainKind::kHull;
  const PlcTriangulation hull = made(input);
  CHECK(hull.simplices.size() > carved.simplices.size());
  CHECK(std::includes(hull.simplices.begin(), hull.simplices.end(), carved.simplices.begin(),
                      carved.simplices.end()));
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
  CHECK(failed.error().cause.why == WhyNoChange::kSegmentMissing);
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

// The obstacle to deleting the polygon from the CDT, which is found by gift-wrapping.
WhyNoChange why_not_deleted(const std::vector<Point>& points,
                            const std::vector<std::vector<Vertex>>& segments,
                            const std::vector<std::vector<Vertex>>& polygons, std::size_t place) {
  PiecewiseLinearInput input{points, segments, {}, {}, DomainKind::kHull};
  for (const auto& line : polygons) input.polygons.push_back({{line}, {}});
  const PiecewiseLinearComplex complex = assemble(input);
  EvolvingCdt cdt = evolving_cdt(complex, gift_wrapping_cdt(complex).value());
  const EvolvingCdt before = cdt;
  const auto wrong = delete_polygon(complex.points, cdt, complex.polygons[place]);
  REQUIRE(wrong.has_value());
  CHECK(cdt == before);
  PiecewiseLinearComplex others = complex;
  others.polygons.erase(others.polygons.begin() + static_cast<std::ptrdiff_t>(place));
  CHECK(!gift_wrapping_cdt(others).has_value());
  return wrong->why;
}

TEST_CASE("a polygon without which there is no CDT is not deleted") {
  CHECK(why_not_deleted({{1, 0, 5}, {5, 0, -1}, {0, -5, -1}, {-1, -5, 0}, {0, 1, 5}},
                        {{0, 4}, {0, 1}, {0, 3}}, {{2, 0, 4}, {2, 4, 1}},
                        0) == WhyNoChange::kFacetUnfinished);
  CHECK(why_not_deleted({{0, 4, -4}, {-4, 4, 0}, {4, 4, 0}, {4, -4, 0}, {4, 0, -4}}, {},
                        {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}},
                        2) == WhyNoChange::kSimplicesOverlap);
  CHECK(
      why_not_deleted(
          {{3, -16, -20}, {-3, 18, -16}, {17, 20, 15}, {10, 19, -5}, {-17, 16, -20}, {-10, -15, 6}},
          {{1, 2}, {3, 4}, {1, 4}}, {{4, 0, 2}, {2, 5, 0}}, 0) == WhyNoChange::kSegmentLost);
}

}  // namespace
}  // namespace circumspect::constrained
