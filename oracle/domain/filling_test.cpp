// Which regions are filled, by the rules that programs have for it.
#include "oracle/domain/filling.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect {

namespace {

// The squares of a box, each turned so that it is counterclockwise seen from outside, or all the
// other way.
PiecewiseLinearInput turned_box(const Rational& low, const Rational& high, bool inward = false) {
  PiecewiseLinearInput box = generators::box(low, high);
  box.polygons.clear();
  for (std::vector<Vertex> line : std::vector<std::vector<Vertex>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    if (inward) std::reverse(line.begin(), line.end());
    box.polygons.push_back({{line}, {}});
  }
  return box;
}

// Where points are once what is not filled has become a hole; "?" if the walls do not say.
std::string places(Fill fill, const PiecewiseLinearInput& input, const std::vector<Point>& points) {
  auto complex = validated(input);
  REQUIRE(complex);
  const auto seeds = seeds_of_unfilled(fill, input, *complex, Regions(*complex));
  if (!seeds) return "?";
  complex->hole_seeds = *seeds;
  complex->kind = kind_of(fill);
  const Regions regions(*complex);
  std::string text;
  for (const Point& point : points) text += regions.locate(point) == Where::kInside ? '+' : '-';
  return text;
}

const std::vector<Point> kFromOutside = {{-1, 5, 5}, {1, 5, 5}, {3, 5, 5}, {5, 5, 5}};

PiecewiseLinearInput three_boxes(bool second_inward) {
  return generators::both(generators::both(turned_box(0, 9), turned_box(2, 8, second_inward)),
                          turned_box(4, 7));
}

// A square of side 4 around (0, 0), its edges one after the other.
std::vector<std::vector<Vertex>> square_edges(Vertex first, bool clockwise) {
  std::vector<std::vector<Vertex>> edges;
  for (Vertex i = 0; i < 4; ++i) {
    std::vector<Vertex> edge = {first + i, first + (i + 1) % 4};
    if (clockwise) std::swap(edge[0], edge[1]);
    edges.push_back(edge);
  }
  return edges;
}

PiecewiseLinearInput two_squares(bool inner_clockwise) {
  PiecewiseLinearInput input;
  for (const long half : {4, 2}) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      input.points.push_back({half * x, half * y});
    }
  }
  input.segments = square_edges(0, false);
  for (auto& edge : square_edges(4, inner_clockwise)) input.segments.push_back(std::move(edge));
  return input;
}

}  // namespace

TEST_CASE("boxes in boxes: every second layer is filled, or all, or as they are turned") {
  for (const bool inward : {false, true}) {
    const PiecewiseLinearInput boxes = three_boxes(inward);
    CHECK(places(Fill::kEnclosed, boxes, kFromOutside) == "-+++");
    CHECK(places(Fill::kEvenOdd, boxes, kFromOutside) == "-+-+");
    CHECK(places(Fill::kWinding, boxes, kFromOutside) == (inward ? "-+-+" : "-+++"));
  }
  // All inside out: wound around −1 times, which is not 0.
  CHECK(places(Fill::kWinding, turned_box(0, 9, true), {{1, 1, 1}, {10, 1, 1}}) == "+-");
}

TEST_CASE("a point of a region is found where the plane of a wall holds the normal of another") {
  // A tetrahedron below a triangle, and a triangle in a plane through the centre of that which
  // stands upright on it.
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0},    {6, 0, 0},    {0, 6, 0},   {0, 0, -6},
                  {-3, -3, -1}, {10, 10, 10}, {-3, -3, 10}};
  input.polygons = {{{{0, 1, 2}}, {}},
                    {{{0, 1, 3}}, {}},
                    {{{0, 2, 3}}, {}},
                    {{{1, 2, 3}}, {}},
                    {{{4, 5, 6}}, {}}};
  CHECK(places(Fill::kEvenOdd, input, {{1, 1, -1}, {1, 1, 1}}) == "+-");
}

TEST_CASE("winding: a wall that is turned against its neighbours is named") {
  PiecewiseLinearInput box = turned_box(0, 9);
  std::reverse(box.polygons[3].lines[0].begin(), box.polygons[3].lines[0].end());
  const auto complex = validated(box);
  REQUIRE(complex);
  const Regions regions(*complex);
  const auto seeds = seeds_of_unfilled(Fill::kWinding, box, *complex, regions);
  REQUIRE(!seeds);
  CHECK(places(Fill::kEvenOdd, box, {{1, 1, 1}}) == "+");
  // A dangling polygon does not count, however it is turned.
  PiecewiseLinearInput with_fin = turned_box(0, 9);
  with_fin.points.push_back({0, 0, 12});
  with_fin.polygons.push_back({{{4, 5, 8}}, {}});
  CHECK(places(Fill::kWinding, with_fin, {{1, 1, 1}, {10, 1, 1}}) == "+-");
}

TEST_CASE("even-odd: two rooms with a wall between them are both entered by one wall") {
  // The wall parts two regions of level 1, where the number of walls depends on the way.
  PiecewiseLinearInput rooms = turned_box(0, 4);
  rooms.polygons.push_back({{{0, 3, 7, 4}}, {}});
  rooms.polygons.erase(rooms.polygons.begin(), rooms.polygons.begin() + 2);
  rooms.polygons.push_back({{{0, 1, 3}}, {}});
  rooms.polygons.push_back({{{0, 2, 3}}, {}});
  rooms.polygons.push_back({{{4, 5, 7}}, {}});
  rooms.polygons.push_back({{{4, 6, 7}}, {}});
  CHECK(places(Fill::kEvenOdd, rooms, {{1, 3, 2}, {3, 1, 2}, {5, 1, 1}}) == "++-");
  const auto complex = validated(rooms);
  REQUIRE(complex);
  CHECK(nesting_levels(Regions(*complex)).wall_of_no_parity);
  const auto nested = validated(three_boxes(false));
  REQUIRE(nested);
  NestingLevels levels = nesting_levels(Regions(*nested));
  CHECK(!levels.wall_of_no_parity);
  std::sort(levels.of_region.begin(), levels.of_region.end());
  CHECK(levels.of_region == std::vector<std::size_t>{0, 1, 2, 3});
}

TEST_CASE("levels: however vertices are numbered, the next wall outwards leads one level down") {
  const std::vector<Point> points = {{0, 0}, {8, 0}, {0, 8}, {2, 2}};
  const std::vector<Simplex> triangle_in_three = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  const std::vector<Simplex> notch_in_two = {{0, 1}, {1, 3}, {2, 3}, {0, 2}, {0, 3}};
  for (const auto& segments : {triangle_in_three, notch_in_two}) {
    Simplex number = {0, 1, 2, 3};
    do {
      PiecewiseLinearInput input;
      input.points.resize(4);
      for (std::size_t v = 0; v < 4; ++v) {
        input.points[static_cast<std::size_t>(number[v])] = points[v];
      }
      for (Simplex segment : segments) {
        for (Vertex& v : segment) v = number[static_cast<std::size_t>(v)];
        input.segments.push_back(segment);
      }
      const auto complex = validated(input);
      REQUIRE(complex);
      const Regions regions(*complex);
      const NestingLevels levels = nesting_levels(regions);
      std::vector<bool> leads_down(regions.size(), false);
      leads_down[Regions::kUnbounded] = true;
      for (std::size_t wall = 0; wall < regions.walls().size(); ++wall) {
        auto [low, high] = regions.beside(wall);
        if (levels.of_region[low] > levels.of_region[high]) std::swap(low, high);
        CHECK(levels.of_region[high] <= levels.of_region[low] + 1);
        if (levels.of_region[high] == levels.of_region[low] + 1) leads_down[high] = true;
      }
      CHECK(leads_down == std::vector<bool>(regions.size(), true));
      REQUIRE(levels.wall_of_no_parity);
      const auto [front, back] = regions.beside(*levels.wall_of_no_parity);
      CHECK((front != back && levels.of_region[front] == levels.of_region[back]));
    } while (std::next_permutation(number.begin(), number.end()));
  }
}

TEST_CASE("in the plane: a square in a square") {
  const std::vector<Point> points = {{5, 0}, {3, 0}, {1, 0}};
  for (const bool clockwise : {false, true}) {
    const PiecewiseLinearInput squares = two_squares(clockwise);
    CHECK(places(Fill::kEnclosed, squares, points) == "-++");
    CHECK(places(Fill::kEvenOdd, squares, points) == "-+-");
    CHECK(places(Fill::kWinding, squares, points) == (clockwise ? "-+-" : "-++"));
  }
  PiecewiseLinearInput mixed = two_squares(false);
  std::swap(mixed.segments[1][0], mixed.segments[1][1]);
  CHECK(places(Fill::kWinding, mixed, points) == "?");
}

TEST_CASE("every enclosed region has a point of its own") {
  const auto complex = validated(three_boxes(false));
  REQUIRE(complex);
  const Regions regions(*complex);
  const std::vector<Point> points = points_of_regions(regions);
  REQUIRE(points.size() == 4);
  for (std::size_t r = 1; r < points.size(); ++r) CHECK(regions.region_at(points[r]) == r);
}

}  // namespace circumspect
