// Regions of the plane and of space, and the polygons made of lines that bound them.
#include "kernel/piecewise_linear/regions.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect {

namespace {

TEST_CASE("assemble: a box has 12 segments and 12 walls") {
  const auto complex = assemble(generators::box(0, 1));
  CHECK(complex.segments.size() == 12);
  CHECK(walls(complex).size() == 12);
  CHECK(complex.polygons[0].vertices == std::vector<Vertex>{0, 1, 2, 3});
}

TEST_CASE("assemble: a square with a square hole, a slit and an isolated vertex") {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 5}, {9, 0, 5}, {9, 9, 5}, {0, 9, 5}, {3, 3, 5}, {6, 3, 5},
                  {6, 6, 5}, {3, 6, 5}, {1, 1, 5}, {2, 1, 5}, {1, 8, 5}, {4, 5, 5}};
  input.segments = {{8, 9}};
  input.polygons = {{{{0, 1, 2, 3}, {4, 5, 6, 7}, {10}}, {{4, 4, 5}}}};
  const auto complex = assemble(input);
  const Polygon& polygon = complex.polygons.front();
  // The slit is adopted, the vertex in the hole is not.
  CHECK(polygon.vertices == std::vector<Vertex>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  CHECK(polygon.segments.size() == 9);
  Rational area = 0;
  for (const Simplex& t : polygon.triangles) {
    const Point u = complex.points[t[1]] - complex.points[t[0]];
    const Point v = complex.points[t[2]] - complex.points[t[0]];
    area += abs(cross_product(u, v, 0, 1)) / 2;
  }
  CHECK(area == 72);
}

TEST_CASE("assemble: an L-shaped polygon without its notch") {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {2, 0, 2}, {2, 1, 2}, {1, 1, 1}, {1, 2, 1}, {0, 2, 0}};
  input.polygons = {{{{0, 1, 2, 3, 4, 5}}, {}}};
  CHECK(assemble(input).polygons.front().triangles.size() == 4);
}

std::size_t count(const Regions& regions, Where where) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) count += regions.where(i) == where ? 1 : 0;
  return count;
}

PiecewiseLinearInput box_in_box() {
  return generators::both(generators::box(0, 9), generators::box(3, 6));
}

TEST_CASE("regions: a box has an inside, and walls face it") {
  const auto complex = assemble(generators::box(0, 2));
  const Regions regions(complex);
  CHECK(regions.size() == 2);
  CHECK(regions.where(Regions::kUnbounded) == Where::kOutside);
  CHECK(regions.locate({1, 1, 1}) == Where::kInside);
  CHECK(regions.locate({1, 1, 2}) == Where::kOnWall);
  CHECK(regions.locate({2, 2, 2}) == Where::kOnWall);
  CHECK(regions.locate({1, 1, 3}) == Where::kOutside);
  CHECK(regions.locate({2, 2, 3}) == Where::kOutside);
  for (const Simplex& wall : walls(complex)) {
    const OrientedFacet facet = OrientedFacet::of(wall);
    CHECK(regions.in_front_of(facet) != regions.in_front_of(facet.reverse()));
    const int side = regions.walls().side_of(regions.walls().place_of(wall), {1, 1, 1});
    CHECK(regions.faces_inside(facet) == (side > 0));
    CHECK(regions.faces_inside(facet.reverse()) == (side < 0));
  }
}

TEST_CASE("regions: a box in a box, joined by no wall, with and without a hole") {
  auto input = box_in_box();
  const Regions solid(assemble(input));
  CHECK(solid.size() == 3);
  CHECK(count(solid, Where::kInside) == 2);
  CHECK(solid.locate({1, 1, 1}) == Where::kInside);
  CHECK(solid.region_at({1, 1, 1}) == solid.region_at({8, 8, 8}));
  CHECK(solid.region_at({1, 1, 1}) != solid.region_at({4, 4, 4}));

  input.hole_seeds = {{4, 4, 4}, {20, 4, 4}};
  const Regions hollow(assemble(input));
  CHECK(hollow.locate({5, 5, 5}) == Where::kHole);
  CHECK(hollow.locate({1, 1, 1}) == Where::kInside);
  CHECK(hollow.ignored_seeds() == std::vector<std::size_t>{1});

  input.kind = DomainKind::kHull;
  const Regions hull(assemble(input));
  CHECK(hull.locate({5, 5, 5}) == Where::kInside);
  CHECK(hull.locate({10, 5, 5}) == Where::kOutside);
  CHECK(hull.where(Regions::kUnbounded) == Where::kInside);
  CHECK(hull.ignored_seeds().size() == 2);
}

TEST_CASE("regions: a tetrahedron in a box that touches it in a vertex alone") {
  auto input = generators::box(0, 9);
  const auto first = static_cast<Vertex>(input.points.size());
  input.points.insert(input.points.end(), {{3, 1, 1}, {1, 3, 1}, {1, 1, 3}});
  for (const auto& face :
       std::vector<std::vector<Vertex>>{{0, 8, 9}, {0, 8, 10}, {0, 9, 10}, {8, 9, 10}}) {
    input.polygons.push_back({{face}, {}});
  }
  CHECK(first == 8);
  const Regions regions(assemble(input));
  CHECK(regions.size() == 3);
  CHECK(regions.region_at({1, 1, 1}) != regions.region_at({5, 5, 5}));
  CHECK(regions.region_at({Rational(1, 100), 1, 1}) == regions.region_at({5, 5, 5}));
  // From outside it is one region as well.
  input.points[8] = {-3, -1, -1};
  input.points[9] = {-1, -3, -1};
  input.points[10] = {-1, -1, -3};
  CHECK(Regions(assemble(input)).size() == 3);
}

TEST_CASE("regions: dangling walls have one region on both sides") {
  auto input = generators::box(0, 4);
  input.points.insert(input.points.end(), {{1, 1, 1}, {3, 1, 1}, {1, 3, 1}, {5, 0, 0}, {6, 2, 2}});
  input.polygons.push_back({{{8, 9, 10}}, {}});
  input.polygons.push_back({{{1, 11, 12}}, {}});
  const auto complex = assemble(input);
  const Regions regions(complex);
  CHECK(regions.size() == 2);
  for (const Simplex& wall : {Simplex{8, 9, 10}, Simplex{1, 11, 12}}) {
    const OrientedFacet facet = OrientedFacet::of(wall);
    CHECK(regions.in_front_of(facet) == regions.in_front_of(facet.reverse()));
  }
  CHECK(regions.faces_inside(OrientedFacet::of({8, 9, 10})));
  CHECK(regions.where(regions.in_front_of(OrientedFacet::of({1, 11, 12}))) == Where::kOutside);
  CHECK(!regions.faces_inside(OrientedFacet::of({1, 11, 12})));
}

TEST_CASE("regions: two boxes that share a face, an edge, a vertex") {
  for (const Point& shift : {Point{1, 0, 0}, Point{1, 1, 0}, Point{1, 1, 1}}) {
    auto first = generators::box(0, 1);
    std::vector<Vertex> place;
    const auto second = generators::box(0, 1);
    for (const Point& corner : second.points) {
      const Point moved = corner + shift;
      const auto found = std::find(first.points.begin(), first.points.end(), moved);
      place.push_back(found - first.points.begin());
      if (found == first.points.end()) first.points.push_back(moved);
    }
    for (auto polygon : second.polygons) {
      bool is_old = true;
      for (Vertex& v : polygon.lines[0]) {
        v = place[static_cast<std::size_t>(v)];
        is_old = is_old && v < 8;
      }
      if (!is_old) first.polygons.push_back(polygon);
    }
    CHECK(Regions(assemble(first)).size() == 3);
  }
}

TEST_CASE("regions: no wall, and a flat complex") {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(Regions(assemble(input)).locate({0, 0, 0}) == Where::kOutside);
  input.kind = DomainKind::kHull;
  CHECK(Regions(assemble(input)).locate({0, 0, 0}) == Where::kInside);
  CHECK(Regions(assemble(input)).locate({1, 1, 1}) == Where::kOutside);
  input.points.pop_back();
  input.polygons = {{{{0, 1, 2}}, {}}};
  const Regions flat(assemble(input));
  CHECK(flat.size() == 1);
  CHECK(flat.where(0) == Where::kOutside);
  CHECK(flat.locate({Rational(1, 4), Rational(1, 4), 0}) == Where::kOnWall);
  CHECK(flat.locate({1, 1, 0}) == Where::kOutside);
}

TEST_CASE("regions of the plane: squares in squares, touching in a vertex, with slits") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 2}, {2, 3}, {5, 5}, {6, 5}, {5, 6}, {8, 8}};
  input.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 4}, {4, 5},
                    {0, 5}, {6, 7}, {7, 8}, {6, 8}, {2, 9}};
  const auto complex = assemble(input);
  const Regions regions(complex);
  CHECK(regions.size() == 4);
  CHECK(regions.region_at({1, 5}) == regions.region_at({8, 1}));
  CHECK(regions.region_at({1, 5}) != regions.region_at({2, 2}));
  CHECK(regions.region_at({Rational(21, 4), Rational(21, 4)}) != regions.region_at({1, 5}));
  CHECK(regions.in_front_of(OrientedFacet::of({2, 9})) ==
        regions.in_front_of(OrientedFacet::of({9, 2})));
  CHECK(regions.in_front_of(OrientedFacet::of({0, 1})) == regions.region_at({1, 5}));
  CHECK(regions.in_front_of(OrientedFacet::of({1, 0})) == Regions::kUnbounded);
  CHECK(regions.locate({Rational(17, 2), Rational(17, 2)}) == Where::kOnWall);
  CHECK(regions.locate({-1, -1}) == Where::kOutside);
  input.kind = DomainKind::kHull;
  input.segments = {{0, 4}};
  CHECK(Regions(assemble(input)).locate({4, 0}) == Where::kInside);
  CHECK(Regions(assemble(input)).locate({4, -1}) == Where::kOutside);
}

}  // namespace
}  // namespace circumspect
