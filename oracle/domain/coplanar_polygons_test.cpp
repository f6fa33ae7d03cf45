// Cells that may meet, and polygons that share a plane.
#include "oracle/domain/coplanar_polygons.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/cell_index.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect {

// Cells that may meet apart from their vertices: all of them are found, and little is looked at.

namespace {

std::vector<std::size_t> by_definition(const std::vector<Box>& boxes,
                                       const std::vector<Simplex>& cells, const Box& box,
                                       const Simplex& vertices) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool shares = std::any_of(cells[i].begin(), cells[i].end(),
                                    [&](Vertex v) { return contains(vertices, v); });
    if (!shares && may_meet_inside(box, boxes[i])) found.push_back(i);
  }
  return found;
}

// Points of a parabola in a plane of space, and one above it.
PointSet rim_and_apex(Vertex rim) {
  std::vector<Point> points;
  for (Vertex i = 0; i < rim; ++i) points.push_back({Rational(i), Rational(i * i), 0});
  points.push_back({Rational(rim) / 2, Rational(rim), Rational(rim)});
  return PointSet(points);
}

// The segments from the apex to the rim, and those of the rim.
std::vector<Simplex> spokes_and_rim(Vertex rim) {
  std::vector<Simplex> segments;
  for (Vertex i = 0; i < rim; ++i) segments.push_back({i, rim});
  for (Vertex i = 0; i + 1 < rim; ++i) segments.push_back({i, i + 1});
  return segments;
}

TEST_CASE("apart: what looking at all cells finds") {
  unsigned state = 7;
  const auto below = [&state](unsigned n) {
    state = state * 1103515245u + 12345u;
    return static_cast<Vertex>((state >> 16) % n);
  };
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> points;
    for (Vertex i = 0; i < 60; ++i) {
      points.push_back({Rational(below(50)), Rational(below(50)), Rational(i, 7)});
      points.back()[2].canonicalize();
    }
    const PointSet set(points);
    // Half of the cells are at one of two vertices of many.
    std::vector<Simplex> cells;
    for (int i = 0; i < 120; ++i) {
      const Vertex v = i % 2 == 0 ? below(2) : below(60);
      const Vertex w = (v + 1 + below(58)) % 60;
      cells.push_back(sorted({v, w}));
    }
    const CellBoxes boxes(set);
    const CellIndex index(boxes.of(cells), cells);
    for (const Simplex& cell : cells) {
      CHECK(index.apart(boxes.of(cell), cell) ==
            by_definition(boxes.of(cells), cells, boxes.of(cell), cell));
    }
    const Simplex nothing;
    CHECK(index.apart(boxes.of(cells[0]), nothing) ==
          by_definition(boxes.of(cells), cells, boxes.of(cells[0]), nothing));
  }
  const std::vector<Simplex> none;
  CHECK(CellIndex({}, none).apart(box_around(Point{0, 0, 0}), {}).empty());
}

TEST_CASE("apart: of cells at one vertex no pair is looked at") {
  constexpr Vertex kRim = 2000;
  const PointSet points = rim_and_apex(kRim);
  const std::vector<Simplex> segments = spokes_and_rim(kRim);
  const CellBoxes boxes(points);
  const CellIndex index(boxes.of(segments), segments);
  for (const Simplex& segment : segments) index.apart(boxes.of(segment), segment);
  CHECK(index.work() < 100 * segments.size());  // of 4,000 × 4,000
}

TEST_CASE("apart: of cells to both sides of a plane that they touch no pair is looked at") {
  constexpr Vertex kRim = 1000;
  std::vector<Point> points = rim_and_apex(kRim).points();
  points.push_back({Rational(kRim) / 2, Rational(kRim), -Rational(kRim)});
  std::vector<Simplex> segments = spokes_and_rim(kRim);
  for (Vertex i = 0; i < kRim; ++i) segments.push_back({i, kRim + 1});
  const PointSet set(points);
  const CellBoxes boxes(set);
  const CellIndex index(boxes.of(segments), segments);
  for (const Simplex& segment : segments) index.apart(boxes.of(segment), segment);
  CHECK(index.work() < 100 * segments.size());  // of 3,000 × 3,000
}

// Polygons of one plane as one.

// Each polygon of one line cut into triangles that fan out from its first corner.
PiecewiseLinearInput in_triangles(const PiecewiseLinearInput& input) {
  PiecewiseLinearInput cut = input;
  cut.polygons.clear();
  for (const PolygonLines& polygon : input.polygons) {
    const std::vector<Vertex>& line = polygon.lines.front();
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      cut.polygons.push_back({{{line[0], line[i], line[i + 1]}}, {}});
    }
  }
  return cut;
}

JoinedPolygons joined(const PiecewiseLinearInput& input) {
  const auto complex = validated(input);
  REQUIRE(complex);
  const JoinedPolygons result = coplanar_polygons_joined(input, *complex);
  CHECK(share_segments_in_one_plane(*complex) ==
        (result.members.size() < complex->polygons.size()));
  // What somebody would have handed in is valid, and is the same complex but for the triangles.
  const auto again = validated(result.input);
  REQUIRE(again);
  CHECK(again->segments == result.complex.segments);
  REQUIRE(again->polygons.size() == result.complex.polygons.size());
  for (std::size_t p = 0; p < again->polygons.size(); ++p) {
    const Polygon& own = result.complex.polygons[p];
    CHECK(again->polygons[p].vertices == own.vertices);
    CHECK(again->polygons[p].segments == own.segments);
    CHECK(again->polygons[p].triangles.size() == own.triangles.size());
  }
  // The polyhedra are the same.
  const Regions before(*complex);
  const Regions after(result.complex);
  CHECK(before.size() == after.size());
  for (const Simplex& wall : walls(*complex)) {
    for (const bool reversed : {false, true}) {
      CHECK(before.where(before.in_front_of({wall, reversed})) ==
            after.where(after.in_front_of({wall, reversed})));
    }
  }
  return result;
}

// Unit squares of the grid in the plane z = 0, each a polygon of its own.
PiecewiseLinearInput squares(Vertex side, const std::vector<std::pair<Vertex, Vertex>>& cells) {
  PiecewiseLinearInput input;
  for (Vertex y = 0; y <= side; ++y) {
    for (Vertex x = 0; x <= side; ++x) input.points.push_back({x, y, 0});
  }
  const auto at = [side](Vertex x, Vertex y) { return y * (side + 1) + x; };
  for (const auto& [x, y] : cells) {
    input.polygons.push_back({{{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)}}, {}});
  }
  return input;
}

}  // namespace

TEST_CASE("the twelve triangles of a box are six squares") {
  const auto result = joined(in_triangles(generators::box(0, 2)));
  CHECK(result.complex.polygons.size() == 6);
  CHECK(result.removed_segments == 6);
  CHECK(result.complex.segments.size() == 12);
  CHECK(result.members[0] == std::vector<std::size_t>{0, 1});
}

TEST_CASE("a segment that is listed stays, and so does one that a polygon of another plane has") {
  PiecewiseLinearInput input = in_triangles(generators::box(0, 2));
  const std::vector<Vertex>& first = input.polygons[0].lines[0];
  input.segments.push_back({first[2], first[0]});
  auto result = joined(input);
  CHECK(result.removed_segments == 5);
  CHECK(result.complex.polygons.size() == 6);
  CHECK(result.complex.polygons[0].segments.size() == 5);

  // A line of two vertices is a segment as well.
  input.segments.clear();
  input.polygons[0].lines.push_back({first[2], first[0]});
  CHECK(joined(input).removed_segments == 5);

  // A wall across the box, upon the diagonals of two of its sides.
  PiecewiseLinearInput wall = in_triangles(generators::box(0, 2));
  wall.polygons.push_back({{{0, 3, 7, 4}}, {}});
  const auto complex = validated(wall);
  REQUIRE(complex);
  const auto with_wall = joined(wall);
  CHECK(with_wall.removed_segments + 2 >= 6);
  for (const Simplex& side : {Simplex{0, 3}, Simplex{4, 7}}) {
    const auto& left = with_wall.complex.segments;
    CHECK(std::binary_search(left.begin(), left.end(), side));
  }
}

TEST_CASE("a ring of squares has a hole, and a vertex inside a joined polygon stays in it") {
  const auto ring =
      joined(squares(3, {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}));
  REQUIRE(ring.complex.polygons.size() == 1);
  const Polygon& polygon = ring.complex.polygons[0];
  REQUIRE(polygon.hole_seeds.size() == 1);
  for (const std::size_t axis : {0, 1}) {
    CHECK(polygon.hole_seeds[0][axis] > 1);
    CHECK(polygon.hole_seeds[0][axis] < 2);
  }
  CHECK(polygon.segments.size() == 16);

  const auto whole = joined(squares(2, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
  REQUIRE(whole.complex.polygons.size() == 1);
  CHECK(whole.complex.polygons[0].hole_seeds.empty());
  CHECK(whole.complex.polygons[0].vertices.size() == 9);
  CHECK(whole.complex.segments.size() == 8);
  CHECK(whole.input.polygons[0].lines.back() == std::vector<Vertex>{4});
}

TEST_CASE("two holes that touch in a corner, and an indentation that is not a hole") {
  // Without the squares (1, 1), (2, 2) and, at the border, (0, 2).
  std::vector<std::pair<Vertex, Vertex>> cells;
  for (Vertex y = 0; y < 4; ++y) {
    for (Vertex x = 0; x < 4; ++x) {
      if (!(x == y && (x == 1 || x == 2)) && !(x == 0 && y == 2)) cells.emplace_back(x, y);
    }
  }
  const auto result = joined(squares(4, cells));
  REQUIRE(result.complex.polygons.size() == 1);
  CHECK(result.complex.polygons[0].hole_seeds.size() == 2);
}

TEST_CASE("polygons that touch in a vertex alone, and those that fold by little, are not joined") {
  CHECK(joined(squares(2, {{0, 0}, {1, 1}})).complex.polygons.size() == 2);
  PiecewiseLinearInput folded = squares(2, {{0, 0}, {1, 0}});
  for (Point& point : folded.points) {
    if (point[0] == 2) point[2] = Rational(1, 1'000'000'000'000'000);
  }
  CHECK(joined(folded).removed_segments == 0);
}

}  // namespace circumspect
