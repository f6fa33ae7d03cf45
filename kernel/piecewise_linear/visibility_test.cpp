// Respecting and visibility by example.
#include "kernel/piecewise_linear/visibility.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"

namespace circumspect {
namespace {

// The vertices that see a simplex, among all vertices but its own.
std::vector<Vertex> seen_from(const PiecewiseLinearInput& input, const Simplex& simplex) {
  const auto complex = assemble(input);
  const Regions regions(complex);
  CHECK(respects(complex, regions, simplex));
  std::vector<Vertex> seen;
  for (Vertex v = 0; complex.points.names(v); ++v) {
    if (contains(simplex, v)) continue;
    const bool visible = is_visible(complex, regions, v, simplex);
    CHECK(visible == visible_point(complex, regions, v, simplex).has_value());
    if (visible) seen.push_back(v);
  }
  return seen;
}

bool respects(const PiecewiseLinearInput& input, const Simplex& simplex) {
  const auto complex = assemble(input);
  return circumspect::respects(complex, Regions(complex), simplex);
}

bool is_seen(const PiecewiseLinearInput& input, Vertex v, const Simplex& simplex) {
  const std::vector<Vertex> seen = seen_from(input, simplex);
  return std::find(seen.begin(), seen.end(), v) != seen.end();
}

void add_polygon(PiecewiseLinearInput& input, std::vector<Vertex> line) {
  input.polygons.push_back({{std::move(line)}, {}});
}

TEST_CASE("respects: Schönhardt's polyhedron holds none of the tetrahedra") {
  const auto input = generators::schonhardt();
  int tetrahedra = 0, triangles = 0, edges = 0;
  for (Vertex a = 0; a < 6; ++a) {
    for (Vertex b = a + 1; b < 6; ++b) {
      edges += respects(input, {a, b}) ? 1 : 0;
      for (Vertex c = b + 1; c < 6; ++c) {
        triangles += respects(input, {a, b, c}) ? 1 : 0;
        for (Vertex e = c + 1; e < 6; ++e) tetrahedra += respects(input, {a, b, c, e}) ? 1 : 0;
      }
    }
  }
  CHECK(edges == 12);
  CHECK(triangles == 8);
  CHECK(tetrahedra == 0);
}

TEST_CASE("visibility: Schönhardt's floor is seen from all of its ceiling") {
  CHECK(seen_from(generators::schonhardt(), {0, 1, 2}) == std::vector<Vertex>{3, 4, 5});
}

// A box of side 6, a tetrahedron in one half and a vertex in the other, and a wall between them.
PiecewiseLinearInput two_rooms() {
  auto input = generators::box(0, 6);
  input.points.insert(input.points.end(), {{1, 2, 2}, {2, 3, 2}, {1, 4, 2}, {1, 3, 3}, {5, 3, 3}});
  return input;
}
const Simplex kTetrahedron = {8, 9, 10, 11};
constexpr Vertex kBeyond = 12;

TEST_CASE("visibility: a polygon occludes a vertex from a tetrahedron (Figure 4.14)") {
  auto input = two_rooms();
  CHECK(is_seen(input, kBeyond, kTetrahedron));
  // A free-standing screen that is large enough, and one that is not.
  const auto first = static_cast<Vertex>(input.points.size());
  input.points.insert(input.points.end(), {{3, 1, 1}, {3, 5, 1}, {3, 5, 5}, {3, 1, 5}});
  add_polygon(input, {first, first + 1, first + 2, first + 3});
  CHECK(!is_seen(input, kBeyond, kTetrahedron));
  for (Point& point : std::span(input.points).subspan(13)) point[2] += 2;
  for (Point& point : std::span(input.points).subspan(15)) point[2] = Rational(11, 2);
  CHECK(is_seen(input, kBeyond, kTetrahedron));
}

TEST_CASE("visibility: a tetrahedron's own facet in a polygon hides all of it") {
  auto input = two_rooms();
  CHECK(respects(input, {8, 9, 10}));
  CHECK(seen_from(input, {8, 9, 10}).size() == 10);
  // v sees only through the facets 8 9 11 and 9 10 11.
  add_polygon(input, {8, 9, 11});
  CHECK(is_seen(input, kBeyond, kTetrahedron));
  add_polygon(input, {9, 10, 11});
  CHECK(!is_seen(input, kBeyond, kTetrahedron));
  // The polygon itself is seen from both sides.
  CHECK(is_seen(input, kBeyond, {9, 10, 11}));
  CHECK(is_seen(input, 8, {9, 10, 11}));
}

TEST_CASE("visibility: through a window in a wall, past a wall in front of it") {
  auto input = two_rooms();
  const auto wall = static_cast<Vertex>(input.points.size());
  input.points.insert(input.points.end(), {{3, 1, 1}, {3, 5, 1}, {3, 5, 5}, {3, 1, 5}});
  const auto window = static_cast<Vertex>(input.points.size());
  const Rational low(11, 4), high(13, 4);
  input.points.insert(input.points.end(),
                      {{3, low, low}, {3, high, low}, {3, high, high}, {3, low, high}});
  input.polygons.push_back(
      {{{wall, wall + 1, wall + 2, wall + 3}, {window, window + 1, window + 2, window + 3}},
       {{3, 3, 3}}});
  CHECK(is_seen(input, kBeyond, kTetrahedron));
  // A pane in two parts, one in front of the window, one behind it; together they cover it.
  const auto pane = static_cast<Vertex>(input.points.size());
  input.points.insert(input.points.end(), {{4, 3, 2}, {4, 4, 2}, {4, 4, 4}, {4, 3, 4}});
  add_polygon(input, {pane, pane + 1, pane + 2, pane + 3});
  CHECK(is_seen(input, kBeyond, kTetrahedron));
  input.points.insert(input.points.end(), {{Rational(5, 2), 2, 2},
                                           {Rational(5, 2), 3, 2},
                                           {Rational(5, 2), 3, 4},
                                           {Rational(5, 2), 2, 4}});
  add_polygon(input, {pane + 4, pane + 5, pane + 6, pane + 7});
  CHECK(!is_seen(input, kBeyond, kTetrahedron));
  input.points[static_cast<std::size_t>(pane) + 5][1] -= Rational(1, 100);
  input.points[static_cast<std::size_t>(pane) + 6][1] -= Rational(1, 100);
  CHECK(is_seen(input, kBeyond, kTetrahedron));
}

TEST_CASE("visibility: a dangling triangle outside sees in its own plane alone, past segments") {
  auto input = generators::box(0, 2);
  input.points.insert(input.points.end(), {{4, 0, 0}, {5, 0, 0}, {4, 1, 0}, {6, 3, 0}, {7, 1, 0}});
  add_polygon(input, {8, 9, 12, 11, 10});
  CHECK(seen_from(input, {8, 9, 10}) == std::vector<Vertex>{11, 12});
  input.segments.push_back({9, 10});
  CHECK(seen_from(input, {8, 9, 10}).empty());
  // Its edge is on the outline of the polygon, and is seen in the same way.
  CHECK(seen_from(input, {8, 9}) == std::vector<Vertex>{10});
}

TEST_CASE("visibility: dangling inside, both sides see") {
  auto input = generators::box(0, 4);
  input.points.insert(input.points.end(), {{1, 1, 2}, {3, 1, 2}, {1, 3, 2}});
  add_polygon(input, {8, 9, 10});
  CHECK(seen_from(input, {8, 9, 10}).size() == 8);
}

TEST_CASE("visibility: a vertex on the line of an edge does not see it") {
  auto input = generators::box(0, 4);
  input.points.insert(input.points.end(), {{1, 1, 1}, {2, 2, 2}});
  CHECK(seen_from(input, {8, 9}) == std::vector<Vertex>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("visibility in the plane: segments occlude, slits, holes, both kinds") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {1, 1}, {3, 1}, {1, 3}, {7, 6}, {5, 1}, {5, 5}};
  input.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  CHECK(seen_from(input, {4, 5, 6}).size() == 7);
  input.segments.push_back({8, 9});  // covers a part
  CHECK(seen_from(input, {4, 5, 6}) == std::vector<Vertex>{0, 1, 2, 3, 8, 9});
  input.segments.push_back({5, 6});
  CHECK(seen_from(input, {4, 5, 6}) == std::vector<Vertex>{0, 1, 3});
  CHECK(seen_from(input, {0, 1}) == std::vector<Vertex>{2, 3, 4, 5, 6, 7, 8, 9});
  input.points[8] = {6, Rational(1, 2)};
  input.points[9] = {3, 7};
  CHECK(seen_from(input, {5, 6}) == std::vector<Vertex>{0, 1, 3, 4, 8, 9});
  // The notch of an L is not in the domain; in the hull kind it is.
  PiecewiseLinearInput bent;
  bent.points = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  bent.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {0, 5}};
  CHECK(seen_from(bent, {2, 3}) == std::vector<Vertex>{0, 1});
  bent.kind = DomainKind::kHull;
  CHECK(seen_from(bent, {2, 3}) == std::vector<Vertex>{0, 1, 4});
}

// A line of sight that passes a corner of a triangle of the polygon that it lies in is not closed
// off by that triangle.
TEST_CASE("visibility: within a dangling polygon, past a vertex inside it") {
  PiecewiseLinearInput input;
  input.points = {{1, -5, 0}, {2, 0, 0}, {3, -5, 0}, {1, 5, 0}, {3, 5, 0},
                  {4, -1, 0}, {4, 1, 0}, {6, 0, 0},  {0, 0, 0}};
  input.polygons = {{{{8, 0, 2, 7, 4, 3}, {1}, {5}, {6}}, {}}};
  const auto complex = assemble(input);
  const Regions regions(complex);
  REQUIRE(respects(complex, regions, {5, 6, 7}));
  CHECK(is_visible(complex, regions, 8, {5, 6, 7}));
}

}  // namespace
}  // namespace circumspect
