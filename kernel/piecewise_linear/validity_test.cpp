// What is a piecewise linear complex, and what is not.
#include "kernel/piecewise_linear/validity.hpp"

#include <array>
#include <set>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/exact/number.hpp"

namespace circumspect {
namespace {

using Lines = std::vector<std::vector<Vertex>>;

// The square 0 1 2 3 with side 8 at height 0, and more points.
PiecewiseLinearInput square(const std::vector<Point>& more = {}, const Lines& lines = {}) {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
  input.points.insert(input.points.end(), more.begin(), more.end());
  input.polygons = {{{{0, 1, 2, 3}}, {}}};
  for (const auto& line : lines) input.polygons.front().lines.push_back(line);
  return input;
}
PiecewiseLinearInput with_segment(PiecewiseLinearInput input, Vertex v, Vertex w) {
  input.segments.push_back({v, w});
  return input;
}
PiecewiseLinearInput with_polygon(PiecewiseLinearInput input, const std::vector<Vertex>& line) {
  input.polygons.push_back({{line}, {}});
  return input;
}
PiecewiseLinearInput with_seed(PiecewiseLinearInput input, const Point& seed) {
  input.polygons.front().hole_seeds.push_back(seed);
  return input;
}

std::vector<Breach> breaches(const PiecewiseLinearInput& input) {
  const auto complex = validated(input);
  return complex ? std::vector<Breach>() : complex.error();
}
bool is_valid(const PiecewiseLinearInput& input) { return breaches(input).empty(); }

TEST_CASE("validated: the named complexes") {
  CHECK(is_valid(generators::box(0, 1)));
  CHECK(is_valid(generators::schonhardt()));
  CHECK(is_valid(generators::cube_with_three_segments()));
  CHECK(is_valid(generators::encircled_segment()));
  CHECK(is_valid(generators::chazelle(2)));
  CHECK(is_valid(generators::both(generators::box(0, 4), generators::box(1, 2))));
  CHECK(is_valid({}));
}

TEST_CASE("plc.index-out-of-range") {
  CHECK(breaches(with_segment(square(), 0, 4)) ==
        std::vector<Breach>{{BreachKind::kIndexOutOfRange, {4}, {{0, 4}}}});
  CHECK(breaches(with_polygon(square(), {0, -1, 1})) ==
        std::vector<Breach>{{BreachKind::kIndexOutOfRange, {-1}, {}, {1}}});
}

TEST_CASE("plc.duplicate-vertex") {
  const Point corner = {8, 0, 0};
  CHECK(breaches(square({corner})) ==
        std::vector<Breach>{{BreachKind::kDuplicateVertex, {1, 4}, {}, {}, corner}});
}

TEST_CASE("plc.degenerate-segment") {
  CHECK(breaches(with_segment(square(), 2, 2)) ==
        std::vector<Breach>{{BreachKind::kDegenerateSegment, {}, {{2, 2}}}});
  PiecewiseLinearInput input = square();
  input.segments = {{1}};
  CHECK(breaches(input) == std::vector<Breach>{{BreachKind::kDegenerateSegment, {}, {{1}}}});
  // A segment listed twice, which is also an edge of a polygon.
  CHECK(is_valid(with_segment(with_segment(square(), 0, 1), 1, 0)));
}

TEST_CASE("plc.degenerate-polygon") {
  CHECK(breaches(with_polygon(square(), {0, 1, 1, 2})) ==
        std::vector<Breach>{{BreachKind::kDegeneratePolygon, {1}, {}, {1}}});
  const std::vector<Point> on_line = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {5, 0, 2}};
  CHECK(breaches(with_polygon(square(on_line), {4, 5})) ==
        std::vector<Breach>{{BreachKind::kDegeneratePolygon, {4, 5}, {}, {1}}});
  // A path there and back encloses nothing.
  CHECK(breaches(with_polygon(square(on_line), {4, 5, 7, 5})) ==
        std::vector<Breach>{{BreachKind::kDegeneratePolygon, {}, {}, {1}}});
  CHECK(breaches(with_polygon(square(), {})) ==
        std::vector<Breach>{{BreachKind::kDegeneratePolygon, {}, {}, {1}}});
  // A triangle with a path to it, and a square with a path to within, there and back.
  CHECK(is_valid(with_polygon(square(on_line), {4, 7, 5, 6, 7})));
  CHECK(is_valid(square({{4, 4, 0}, {4, 6, 0}}, {{0, 4, 5, 4}})));
}

TEST_CASE("plc.polygon-not-planar: how far off the plane that is nearest to all vertices") {
  PiecewiseLinearInput input = square();
  input.points[3][2] = Rational(-1, 3);
  // Halfway between planes through the two diagonals.
  Breach expected{BreachKind::kPolygonNotPlanar, {0, 1, 2, 3}, {}, {0}};
  expected.squared_distance = Rational(8, 1153);
  CHECK(breaches(input) == std::vector<Breach>{expected});
  // The first three corners are nearly in one line, and the others one off their plane. One breach,
  // not two.
  PiecewiseLinearInput narrow;
  for (const auto& [x, y, z] :
       {std::array{.1, .3, 0.}, {.2, .6, 0.}, {.3, .9, 0.}, {.3, .9, 1.}, {.1, .3, 1.}}) {
    narrow.points.push_back({exact_value(x), exact_value(y), exact_value(z)});
  }
  narrow.polygons = {{{{0, 1, 2, 3, 4}}, {}}};
  REQUIRE(breaches(narrow).size() == 1);
  const Breach breach = breaches(narrow).front();
  CHECK(breach.kind == BreachKind::kPolygonNotPlanar);
  CHECK(*breach.squared_distance > 0);
  CHECK(*breach.squared_distance <
        Rational(1, 1'000'000'000'000'000) * Rational(1, 1'000'000'000'000'000));
  // Planar, but not parallel to an axis.
  PiecewiseLinearInput slanted = square();
  for (Point& p : slanted.points) p[2] = p[0] / 3 + p[1] / 7;
  CHECK(is_valid(slanted));
}

TEST_CASE("plc.vertex-in-segment") {
  CHECK(breaches(square({{4, 0, 0}})) ==
        std::vector<Breach>{{BreachKind::kVertexInSegment, {4}, {{0, 1}}, {}, Point{4, 0, 0}}});
  CHECK(is_valid(square({{4, 0, Rational(1, 1000000)}, {9, 0, 0}})));
}

TEST_CASE("plc.crossing-segments") {
  const auto input = square({{4, -1, 0}, {4, 1, 0}});
  CHECK(breaches(with_segment(input, 4, 5)) ==
        std::vector<Breach>{
            {BreachKind::kCrossingSegments, {}, {{0, 1}, {4, 5}}, {}, Point{4, 0, 0}}});
  CHECK(is_valid(with_segment(square({{4, -1, 0}, {4, 1, 1}}), 4, 5)));
  // A line that crosses itself.
  CHECK(breaches(with_polygon(square({{0, 0, 5}, {2, 2, 5}, {2, 0, 5}, {0, 2, 5}}), {4, 5, 6, 7}))
            .front() ==
        Breach{BreachKind::kCrossingSegments, {}, {{4, 5}, {6, 7}}, {}, Point{1, 1, 5}});
}

TEST_CASE("plc.segment-pierces-polygon") {
  const auto input = square({{3, 1, -1}, {3, 1, 1}, {3, 1, 0}});
  // Vertex 6 lies on the segment; without it the segment goes through.
  CHECK(breaches(with_segment(input, 4, 5)).front().kind == BreachKind::kVertexInSegment);
  CHECK(
      breaches(with_segment(square({{3, 1, -1}, {3, 1, 2}}), 4, 5)) ==
      std::vector<Breach>{{BreachKind::kSegmentPiercesPolygon, {}, {{4, 5}}, {0}, Point{3, 1, 0}}});
  // It goes through the diagonal of the square, whichever is drawn: one breach.
  CHECK(breaches(with_segment(square({{4, 4, -1}, {4, 4, 1}}), 4, 5)).size() == 1);
  // It reaches up to the polygon: its end is adopted.
  CHECK(is_valid(with_segment(input, 4, 6)));
  CHECK(is_valid(with_segment(square({{9, 1, -1}, {9, 1, 1}}), 4, 5)));
}

TEST_CASE("plc.polygons-cross: their vertices are in place, the segment between them is not") {
  const std::vector<Point> upright = {{2, 2, 0}, {4, 2, 0}, {3, 2, 1}, {3, 2, -1}};
  PiecewiseLinearInput input = with_polygon(square(upright), {4, 6, 5, 7});
  const auto found = breaches(input);
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == BreachKind::kPolygonsCross);
  CHECK(found[0].polygons == std::vector<std::size_t>{0, 1});
  const Point& witness = *found[0].point;
  CHECK((witness[0] > 2 && witness[0] < 4 && witness[1] == 2 && witness[2] == 0));
  CHECK(is_valid(with_segment(input, 4, 5)));
  // It stands on the square with an edge, which is a slit of the square.
  CHECK(is_valid(with_polygon(square(upright), {4, 5, 6})));
  // It touches the square in a vertex.
  CHECK(is_valid(with_polygon(square({{2, 2, 0}, {2, 2, 1}, {3, 2, 1}}), {4, 5, 6})));
}

TEST_CASE("plc.polygons-overlap") {
  const Breach twice = breaches(with_polygon(square(), {3, 2, 1, 0})).front();
  CHECK(twice.kind == BreachKind::kPolygonsOverlap);
  CHECK(twice.polygons == std::vector<std::size_t>{0, 1});
  const std::vector<Point> inner = {{2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}};
  const auto within = breaches(with_polygon(square(inner), {4, 5, 6, 7}));
  REQUIRE(within.size() == 1);
  CHECK(within[0].kind == BreachKind::kPolygonsOverlap);
  const Point& witness = *within[0].point;
  CHECK((witness[0] > 2 && witness[0] < 4 && witness[1] > 2 && witness[1] < 4));
  // The same square in a hole, and one that shares an edge.
  CHECK(is_valid(with_polygon(with_seed(square(inner, {{4, 5, 6, 7}}), {3, 3, 0}), {4, 5, 6, 7})));
  CHECK(is_valid(with_polygon(square({{12, 0, 0}, {12, 8, 0}}), {1, 4, 5, 2})));
}

// A polygon in the plane y = 0 (else x = 0) that lies on both sides of the line from (0, 0, 0) to
// (0, 0, 1), with a saw of so many teeth on one side.
PiecewiseLinearInput with_saw(PiecewiseLinearInput input, Vertex teeth, bool in_x) {
  std::vector<Vertex> line = {0};
  const auto add = [&](const Rational& along, Rational height) {
    height.canonicalize();
    line.push_back(static_cast<Vertex>(input.points.size()));
    input.points.push_back(in_x ? Point{along, 0, height} : Point{0, along, height});
  };
  for (Vertex i = 0; i < teeth; ++i) {
    add(5, Rational(4 * i + 1, 4 * teeth));
    add(6, Rational(4 * i + 3, 4 * teeth));
  }
  line.push_back(1);
  add(-2, Rational(1, 2));
  input.polygons.push_back({{line}, {}});
  return input;
}

TEST_CASE("plc.polygons-cross: polygons of few and of many vertices") {
  PiecewiseLinearInput ends;
  ends.points = {{0, 0, 0}, {0, 0, 1}};
  for (const Vertex teeth : {1, 20}) {
    for (const Vertex others : {1, 20}) {
      PiecewiseLinearInput input = with_saw(with_saw(ends, teeth, true), others, false);
      const auto found = breaches(input);
      REQUIRE(!found.empty());
      CHECK(found[0].kind == BreachKind::kPolygonsCross);
      CHECK(found[0].polygons == std::vector<std::size_t>{0, 1});
    }
  }
}

TEST_CASE("plc.polygons-overlap: polygons of few and of many vertices that share some") {
  // Fans over the same ends, one within the other.
  for (const Vertex inner : {1, 20}) {
    for (const Vertex outer : {1, 20}) {
      PiecewiseLinearInput input;
      input.points = {{0, 0, 0}, {100, 0, 0}};
      for (const auto& [count, height] : {std::pair{inner, 1}, std::pair{outer, 2}}) {
        std::vector<Vertex> line = {0, 1};
        for (Vertex i = count; i > 0; --i) {
          line.push_back(static_cast<Vertex>(input.points.size()));
          const Rational x = Rational(100 * i, count + 1);
          input.points.push_back({x, height * x * (100 - x) / 100, 0});
          for (Rational& c : input.points.back()) c.canonicalize();
        }
        input.polygons.push_back({{line}, {}});
      }
      const auto found = breaches(input);
      REQUIRE(!found.empty());
      CHECK(found[0].kind == BreachKind::kPolygonsOverlap);
    }
  }
}

TEST_CASE("plc.polygon-hole-seed") {
  const auto holed = square({{2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}}, {{4, 5, 6, 7}});
  CHECK(is_valid(with_seed(with_seed(holed, {3, 3, 0}), {Rational(5, 2), 3, 0})));
  const auto one = [&](const Point& seed) { return breaches(with_seed(holed, seed)).front(); };
  for (const Point& seed : {Point{3, 3, 1}, {3, 2, 0}, {4, 4, 0}, {9, 9, 0}, {3, -1, 0}}) {
    CHECK(one(seed).kind == BreachKind::kPolygonHoleSeed);
    CHECK(one(seed).point == seed);
  }
  CHECK(one({3, 3, Rational(1, 9)}).offset == Rational(1, 9));
  CHECK(one({3, 2, 0}).segments == std::vector<Simplex>{{4, 5}});
  CHECK(one({4, 4, 0}).vertices == std::vector<Vertex>{6});
}

TEST_CASE("plc.polygon-hole-seed: a seed in what borders on the outside makes no hole") {
  const auto in_no_hole = [](const PiecewiseLinearInput& input, const Point& seed) {
    const std::vector<Breach> found = breaches(with_seed(input, seed));
    return found == std::vector<Breach>{{BreachKind::kPolygonHoleSeed, {}, {}, {0}, seed}};
  };
  // The polygon would be empty, or only what should be a hole would remain.
  CHECK(in_no_hole(square(), {3, 3, 0}));
  const auto holed = square({{2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}}, {{4, 5, 6, 7}});
  CHECK(in_no_hole(holed, {1, 1, 0}));
  CHECK(in_no_hole(with_seed(holed, {3, 3, 0}), {1, 1, 0}));
  // On either side of a line from corner to corner.
  CHECK(in_no_hole(square({}, {{0, 2}}), {3, 1, 0}));
  CHECK(in_no_hole(square({}, {{0, 2}}), {1, 3, 0}));
  // A hole may touch the outline in a vertex, and may be parted by a line.
  const auto pinched = square({{2, 2, 0}, {4, 2, 0}}, {{0, 4, 5}});
  CHECK(is_valid(with_seed(pinched, {2, Rational(3, 2), 0})));
  const auto parted = square({{2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}}, {{4, 5, 6, 7}, {4, 6}});
  CHECK(is_valid(with_seed(with_seed(parted, {3, Rational(5, 2), 0}), {Rational(5, 2), 3, 0})));
}

TEST_CASE("plc.hole-seed-on-wall") {
  PiecewiseLinearInput input = generators::box(0, 4);
  input.hole_seeds = {{1, 1, 0}};
  CHECK(breaches(input) ==
        std::vector<Breach>{{BreachKind::kHoleSeedOnWall, {}, {}, {0}, Point{1, 1, 0}}});
  input.hole_seeds = {{1, 1, 1}, {9, 9, 9}};
  CHECK(is_valid(input));
}

TEST_CASE("adoptions: vertices, slits, and what lies outside its polygon") {
  auto input = square({{2, 2, 0}, {4, 2, 0}, {6, 6, 0}, {9, 9, 0}}, {{7}, {2, 7}});
  input.segments = {{4, 5}};
  const auto complex = validated(input);
  REQUIRE(complex);
  CHECK(complex->polygons[0].vertices == std::vector<Vertex>{0, 1, 2, 3, 4, 5, 6});
  const auto adopted = adoptions(input, *complex);
  REQUIRE(adopted.size() == 1);
  CHECK(adopted[0].vertices == std::vector<Vertex>{4, 5, 6});
  CHECK(adopted[0].segments == std::vector<Simplex>{{4, 5}});
  CHECK(adopted[0].left_vertices == std::vector<Vertex>{7});
  CHECK(adopted[0].left_segments == std::vector<Simplex>{{2, 7}});
  CHECK(adoptions(square(), *validated(square())).empty());
}

TEST_CASE("validated: reports up to a limit") {
  PiecewiseLinearInput input = square();
  input.segments.assign(50, {7, 8});
  CHECK(validated(input).error().size() == kBreachLimit);
  CHECK(validated(input, 3).error().size() == 3);
  CHECK(validated(input, 0).error().size() == 100);
}

TEST_CASE("breach kinds: every one has its own identifier") {
  std::set<std::string_view> seen;
  for (const BreachEntry& entry : breach_kinds()) {
    CHECK(seen.insert(entry.identifier).second);
    CHECK(identifier(entry.kind) == entry.identifier);
    CHECK(meaning(entry.kind) == entry.meaning);
  }
}

PiecewiseLinearInput plane(const std::vector<Point>& points, const std::vector<Simplex>& segments,
                           const std::vector<Point>& seeds = {}) {
  PiecewiseLinearInput input;
  input.points = points;
  input.segments = segments;
  input.hole_seeds = seeds;
  return input;
}

const std::vector<Point> kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const std::vector<Simplex> kSides = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};

TEST_CASE("validated in the plane: legal inputs") {
  CHECK(breaches(plane(kSquare, kSides)).empty());
  CHECK(breaches(plane(kSquare, {{0, 2}, {2, 0}, {0, 2}})).empty());
  // An isolated vertex, and a seed right there and outside: none is on a segment.
  std::vector<Point> points = kSquare;
  points.push_back({1, 2});
  CHECK(breaches(plane(points, kSides, {{1, 2}, {9, 9}})).empty());
  CHECK(breaches(plane({{0, 0}, {1, 1}, {2, 2}}, {{0, 1}, {1, 2}})).empty());
}

TEST_CASE("validated in the plane: lists") {
  CHECK(breaches(plane(kSquare, {{0, 4}})).front().kind == BreachKind::kIndexOutOfRange);
  CHECK(breaches(plane(kSquare, {{1, 1}})).front().kind == BreachKind::kDegenerateSegment);
  CHECK(breaches(plane({{0, 0}, {1, 0}, {0, 0}}, {})) ==
        std::vector<Breach>{{BreachKind::kDuplicateVertex, {0, 2}, {}, {}, Point{0, 0}}});
}

TEST_CASE("validated in the plane: vertices and segments") {
  CHECK(
      breaches(plane(kSquare, {{0, 2}, {1, 3}})) ==
      std::vector<Breach>{{BreachKind::kCrossingSegments, {}, {{0, 2}, {1, 3}}, {}, Point{2, 2}}});
  const std::vector<Point> row = {{0, 0}, {1, 1}, {3, 3}, {4, 4}};
  CHECK(breaches(plane(row, {{0, 2}})) ==
        std::vector<Breach>{{BreachKind::kVertexInSegment, {1}, {{0, 2}}, {}, Point{1, 1}}});
  // Segments of one line that overlap have vertices inside one another.
  CHECK(breaches(plane(row, {{0, 2}, {1, 3}})).size() == 2);
  // A T: the end of one inside the other, which is not a crossing.
  CHECK(breaches(plane({{0, 0}, {4, 0}, {2, 0}, {2, 3}}, {{0, 1}, {2, 3}})) ==
        std::vector<Breach>{{BreachKind::kVertexInSegment, {2}, {{0, 1}}, {}, Point{2, 0}}});
}

TEST_CASE("validated in the plane: a hole seed on a segment") {
  CHECK(breaches(plane(kSquare, kSides, {{1, 1}, {Rational(1, 3), 0}})) ==
        std::vector<Breach>{
            {BreachKind::kHoleSeedOnWall, {}, {{0, 1}}, {}, Point{Rational(1, 3), 0}}});
}

}  // namespace
}  // namespace circumspect
