// Polygons of nearly one plane as one: docs/theory/within.md, "Polygons that are not flat".
#include "oracle/judge/within/nearly_coplanar.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/judge/within/moved_meshes_test.hpp"

namespace circumspect::check {
namespace {

PiecewiseLinearComplex valid(const PiecewiseLinearInput& input) {
  auto complex = validated(input);
  REQUIRE(complex);
  return std::move(*complex);
}

// About 0.1 degrees, and so many billionths.
Flatness flatness(long bits) { return {Rational(3, 1'000'000), bits * kBit * (bits * kBit)}; }

// A square of two triangles, one of whose corners is `bits` billionths too high.
PiecewiseLinearInput bent_square(long bits) {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, bits * kBit}};
  input.polygons = {{{{0, 1, 2}}, {}}, {{{0, 2, 3}}, {}}};
  return input;
}

std::size_t joined_polygons(const PiecewiseLinearInput& input, long bits) {
  return nearly_coplanar_polygons_joined(valid(input), listed_segments(input), flatness(bits))
      .complex.polygons.size();
}

// A cube whose corner 7 is a few billionths off; squares cut across the diagonals 12, 56, 14, 36,
// 24, 35.
PiecewiseLinearInput bent_cube() {
  PiecewiseLinearInput cube = generators::box(0, 1);
  cube.points[7] = {1 + 2 * kBit, 1 - kBit, 1 + 3 * kBit};
  cube.polygons.clear();
  for (const Simplex& line : std::vector<Simplex>{{0, 1, 2},
                                                  {3, 1, 2},
                                                  {4, 5, 6},
                                                  {7, 5, 6},
                                                  {0, 1, 4},
                                                  {5, 1, 4},
                                                  {2, 3, 6},
                                                  {7, 3, 6},
                                                  {0, 2, 4},
                                                  {6, 2, 4},
                                                  {1, 3, 5},
                                                  {7, 3, 5}}) {
    cube.polygons.push_back({{line}, {}});
  }
  return cube;
}

}  // namespace

TEST_CASE("polygons are joined up to a distance from one plane, and not beyond it") {
  CHECK(joined_polygons(bent_square(3), 3) == 1);
  CHECK(joined_polygons(bent_square(4), 3) == 2);
  PiecewiseLinearInput with_seam = bent_square(3);
  with_seam.segments = {{2, 0}};
  CHECK(joined_polygons(with_seam, 3) == 2);
  // The same height of a corner bends a short triangle by too great an angle.
  PiecewiseLinearInput steep = bent_square(3);
  steep.points[3] = {Rational(1, 2) - kBit, Rational(1, 2) + kBit, 3 * kBit};
  CHECK(joined_polygons(steep, 3) == 2);
}

TEST_CASE("the angle is that of two polygons beside each other, not that with the first") {
  // Strips, each a little steeper than the one before: 0.0016 is about 0.09 degrees.
  PiecewiseLinearInput strips;
  Rational height = 0;
  for (int i = 0; i <= 3; ++i) {
    height += i * Rational(16, 10'000);
    strips.points.push_back({i, 0, height});
    strips.points.push_back({i, 9, height});
  }
  for (Vertex i = 0; i < 6; i += 2) strips.polygons.push_back({{{i, i + 1, i + 3, i + 2}}, {}});
  const auto joined_of = [&](const Rational& slope) {
    return nearly_coplanar_polygons_joined(valid(strips), {}, {slope * slope, 1})
        .complex.polygons.size();
  };
  CHECK(joined_of(Rational(17, 10'000)) == 1);
  CHECK(joined_of(Rational(15, 10'000)) == 3);
}

TEST_CASE("a joined polygon has the vertices and segments of its members, and their plane first") {
  const PiecewiseLinearInput input = bent_square(3);
  const auto joined =
      nearly_coplanar_polygons_joined(valid(input), listed_segments(input), flatness(3));
  REQUIRE(joined.members == std::vector<std::vector<std::size_t>>{{0, 1}});
  CHECK(joined.removed_segments == 1);
  CHECK(joined.complex.segments.size() == 4);
  CHECK(joined.complex.polygons[0].vertices.size() == 4);
  CHECK(joined.complex.polygons[0].segments.size() == 4);
  CHECK(joined.squared_height > 0);
  CHECK(joined.squared_height <= 9 * kBit * kBit);
}

TEST_CASE("what folds back is not joined, and other cells bar it or limit the distance") {
  PiecewiseLinearInput folded = bent_square(3);
  folded.points[3] = {1, Rational(1, 4), 3 * kBit};  // over the first triangle
  auto joined =
      nearly_coplanar_polygons_joined(valid(folded), listed_segments(folded), flatness(3));
  CHECK(joined.complex.polygons.size() == 2);
  CHECK(joined.refused == 1);
  folded.points[3] = {1, 0, 3 * kBit};  // over a vertex of it
  joined = nearly_coplanar_polygons_joined(valid(folded), listed_segments(folded), flatness(3));
  CHECK(joined.refused == 1);

  PiecewiseLinearInput near = bent_square(3);
  near.points.push_back({Rational(1, 2), Rational(1, 4), 20 * kBit});
  joined = nearly_coplanar_polygons_joined(valid(near), listed_segments(near), flatness(3));
  CHECK(joined.refused == 1);
  CHECK(!joined.squared_limit);
  near.points.back()[2] = 250 * kBit;
  joined = nearly_coplanar_polygons_joined(valid(near), listed_segments(near), flatness(3));
  CHECK(joined.complex.polygons.size() == 1);
  CHECK(joined.squared_limit == 250 * kBit * (250 * kBit) / 32);
  near.points.back()[2] = 1000 * kBit;
  joined = nearly_coplanar_polygons_joined(valid(near), listed_segments(near), flatness(3));
  CHECK(joined.complex.polygons.size() == 1);
  CHECK(!joined.squared_limit);
}

TEST_CASE("a mesh with other diagonals holds for the joined polygons, and nothing is hidden") {
  const PiecewiseLinearInput input = bent_cube();
  const Domain flat{valid(input)};
  const auto joined =
      nearly_coplanar_polygons_joined(flat.complex, listed_segments(input), flatness(10));
  CHECK(joined.complex.polygons.size() == 6);
  const Domain bent{joined.complex};
  // Six tetrahedra around the diagonal from 0 to 7.
  std::vector<Simplex> cells = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7},
                                {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};
  const Rational squared = 10 * kBit * (10 * kBit);
  const auto answer = [&](const std::vector<Simplex>& simplices, Claim claim) {
    const ExactMesh mesh{PointSet(input.points), simplices};
    return judge_within(claim, mesh, bent, squared, {}, nullptr, &flat);
  };
  const auto holds = answer(cells, Claim::kSteinerTriangulation);
  REQUIRE(holds);
  CHECK(holds->holds());
  CHECK(!judge_within(Claim::kSteinerTriangulation, {PointSet(input.points), cells}, flat, squared)
             ->holds());
  // Rounded otherwise, it holds as well: the distance is that of the vertices.
  ExactMesh moved{PointSet(input.points), cells};
  std::vector<Point> points = input.points;
  points[7][0] += 2 * kBit;
  moved = {PointSet(points), cells};
  const auto rounded =
      judge_within(Claim::kSteinerTriangulation, moved, bent, squared, {}, nullptr, &flat);
  REQUIRE(rounded);
  CHECK(rounded->holds());
  CHECK(rounded->within->squared_reach == 4 * kBit * kBit);
  // A tetrahedron is missing.
  cells.erase(cells.begin());
  const auto missing = answer(cells, Claim::kSteinerTriangulation);
  REQUIRE(missing);
  CHECK(!missing->holds());
}

TEST_CASE("a segment stays for certain if no way leads around it by small angles") {
  const Rational slope = flatness(0).squared_slope;
  const PiecewiseLinearComplex cube = valid(bent_cube());
  const StayingSegments of_cube(cube, slope);
  CHECK(of_cube.certainly({0, 1}));   // an edge of the cube
  CHECK(!of_cube.certainly({1, 2}));  // a diagonal of a square
  CHECK(!of_cube.certainly({5, 6}));  // of one that is bent a little
  // Two triangles of nearly one plane, and a steep one beside them.
  PiecewiseLinearInput fan;
  fan.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, bits(9)}, {-1, 0, Rational(1, 9)}};
  fan.polygons = {{{{0, 1, 2}}, {}}, {{{0, 2, 3}}, {}}, {{{0, 3, 4}}, {}}};
  const PiecewiseLinearComplex open = valid(fan);
  const StayingSegments of_fan(open, slope);
  CHECK(!of_fan.certainly({0, 2}));
  CHECK(of_fan.certainly({0, 3}));
  CHECK(of_fan.certainly({0, 1}));  // of one polygon
}

TEST_CASE("what a polygon is cut into says which polygon that was, flat ones included") {
  Dice dice(1);
  PiecewiseLinearInput input = drawn_rounded(dice, 4);
  for (int copy = 0; copy < 2; ++copy) {
    input.polygons.insert(input.polygons.begin(), {{{0, 1, 2}}, {}});
    input.polygons.push_back({{{2, 3, 4}}, {}});
  }
  const auto cut = rounded_polygons_cut(input, 1);
  REQUIRE(cut);
  CHECK(cut->cut == 1);
  CHECK(cut->cut_of == std::vector<std::size_t>{0, 1, 2, 2, 2, 3, 4});
  REQUIRE(cut->input.polygons.size() == cut->cut_of.size());
  for (std::size_t p = 0; p < cut->cut_of.size(); ++p) {
    const std::vector<Vertex> whole = vertices_of(input.polygons[cut->cut_of[p]]);
    for (const Vertex v : cut->input.polygons[p].lines[0]) CHECK(contains(whole, v));
  }
}

}  // namespace circumspect::check
