// The least reach at which the cells of a small domain have images.
#include "oracle/judge/definition/within.hpp"

#include <doctest/doctest.h>

namespace circumspect::definition {
namespace {

// Everything in a mesh is used. `meant`: triangles for the first polygon.
auto reach_of(const ExactMesh& mesh, const PiecewiseLinearInput& input,
              const Rational& squared_limit, const std::vector<Simplex>& meant = {}) {
  const PiecewiseLinearComplex complex = assemble(input);
  const std::vector<bool> used(mesh.points.size(), true);
  std::vector<std::vector<Simplex>> all_meant(complex.polygons.size());
  if (!meant.empty()) all_meant.front() = meant;
  return least_reach({complex, Regions(complex), mesh, used, all_meant}, squared_limit);
}

const PiecewiseLinearInput kTriangle{{{0, 0}, {80, 0}, {0, 60}}, {{0, 1}, {1, 2}, {0, 2}}, {}, {}};

TEST_CASE("a path is as far from its segment as its farthest vertex") {
  // Two vertices below the first edge, 3 and 5 off the line through it.
  const auto with = [](const Point& p, const Point& q) {
    return ExactMesh{PointSet({{0, 0}, {80, 0}, {0, 60}, p, q}), {{0, 3, 2}, {3, 4, 2}, {4, 1, 2}}};
  };
  const auto found = reach_of(with({20, -3}, {60, 5}), kTriangle, 100);
  REQUIRE(found.has_value());
  CHECK(found->squared_reach == 25);
  CHECK(found->images == definition::CellImages{{{0, 0}, {{0}}},
                                                {{0, 1}, {{1}}},
                                                {{0, 2}, {{2}}},
                                                {{1, 0}, {{0, 3}, {3, 4}, {4, 1}}},
                                                {{1, 1}, {{0, 2}}},
                                                {{1, 2}, {{1, 2}}}});
  CHECK(found->carriers[3] == LinearCell{1, 0});
  CHECK(reach_of(with({20, -3}, {60, 5}), kTriangle, 25).has_value());
  const auto none = reach_of(with({20, -3}, {60, 5}), kTriangle, 24);
  CHECK(none.error().has_value());
  CHECK(none.error()->rule == Rule::kSegmentMissing);
  CHECK(none.error()->witness.domain_cell == Simplex{0, 1});
  // At the end of the first segment a vertex is nearer to its end than to its line, and no edge
  // leads there.
  CHECK(reach_of(with({20, 0}, {60, 0}), kTriangle, 100)->squared_reach == 0);
  CHECK(reach_of(with({60, 0}, {20, 0}), kTriangle, 100).error().has_value());
}

TEST_CASE("a vertex is moved, is missing, or is there twice") {
  const auto with = [](const std::vector<Point>& points, const std::vector<Simplex>& simplices) {
    return reach_of({PointSet(points), simplices}, kTriangle, 100);
  };
  const auto moved = with({{0, 0}, {83, 4}, {0, 60}}, {{0, 1, 2}});
  CHECK(moved->squared_reach == 25);
  CHECK(moved->carriers[1] == LinearCell{0, 1});
  const auto missing = with({{0, 0}, {80, 11}, {0, 60}}, {{0, 1, 2}});
  CHECK(missing.error().has_value());
  CHECK(missing.error()->rule == Rule::kDomainVertexMissing);
  CHECK(missing.error()->witness.domain_cell == Simplex{1});
  // Vertices at 3 and at 4 from one vertex of the domain: from 4 on that tells nothing.
  const auto twice = with({{-3, 0}, {80, 0}, {0, 60}, {0, -4}}, {{0, 1, 2}, {0, 1, 3}});
  CHECK(twice.has_value());
  CHECK(twice->squared_reach == 9);
  const auto both = with({{-3, 0}, {86, 0}, {0, 60}, {0, -4}}, {{0, 1, 2}, {0, 1, 3}});
  CHECK(both.error() == std::nullopt);
}

TEST_CASE("cells that do not meet are told apart up to a third of their distance") {
  // Skew segments, 12 apart, and a triangle 12 above the foot of a vertex.
  const auto is_found = [](const PiecewiseLinearInput& input, std::size_t moved, long by) {
    std::vector<Point> points = input.points;
    points[moved][0] += by;
    ExactMesh mesh{PointSet(points), {}};
    mesh.faces = input.segments;
    for (const PolygonLines& polygon : input.polygons) mesh.faces.push_back(polygon.lines.front());
    return reach_of(mesh, input, 10000).has_value();
  };
  const PiecewiseLinearInput skew{
      {{0, -99, 0}, {0, 99, 0}, {-99, 0, 12}, {99, 0, 12}}, {{0, 1}, {2, 3}}, {}, {}};
  CHECK(is_found(skew, 3, 3));
  CHECK(!is_found(skew, 3, 4));
  CHECK(!is_found(skew, 3, 5));
  const PiecewiseLinearInput above{{{0, 0, 0}, {90, 0, 0}, {0, 90, 0}, {10, 10, 12}, {50, 50, 99}},
                                   {{3, 4}},
                                   {{{{0, 1, 2}}, {}}},
                                   {}};
  CHECK(is_found(above, 4, 3));
  CHECK(!is_found(above, 4, 4));
}

TEST_CASE("the triangles of a polygon are found, and the better of two choices") {
  // Vertex 4 is the middle of a square, moved up by 3; or the square is cut along a diagonal.
  const PiecewiseLinearInput square{
      {{0, 0, 0}, {90, 0, 0}, {90, 90, 0}, {0, 90, 0}}, {}, {{{{0, 1, 2, 3}}, {}}}, {}};
  const auto with = [&](const Point& middle, const std::vector<Simplex>& faces) {
    std::vector<Point> points = square.points;
    points.push_back(middle);
    ExactMesh mesh{PointSet(points), {}};
    mesh.faces = faces;
    return reach_of(mesh, square, 100);
  };
  const std::vector<Simplex> fan = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 4}};
  const auto found = with({40, 40, 3}, fan);
  CHECK(found->squared_reach == 9);
  CHECK(found->images.at({2, 0}).size() == 4);
  CHECK(with({40, 40, 0}, fan)->squared_reach == 0);
  const std::vector<Simplex> open(fan.begin(), fan.end() - 1);
  CHECK(with({40, 40, 3}, open).error()->rule == Rule::kSegmentMissing);
  std::vector<Simplex> with_edge = open;
  with_edge.push_back({0, 3});
  CHECK(with({40, 40, 3}, with_edge).error()->rule == Rule::kPolygonNotTiled);
  // Beyond an edge it is nearest to that, so that the path goes there.
  const auto beyond = with({95, 40, 3}, fan);
  CHECK(beyond->squared_reach == 34);
  CHECK(beyond->images.at({2, 0}).size() == 3);
  // A step has two triangles that stand upright: they are no part of it, even if they are meant.
  const std::vector<Simplex> stairs = {{0, 1, 2}, {0, 1, 5}, {2, 3, 4},
                                       {3, 4, 5}, {0, 2, 3}, {0, 3, 5}};
  const auto stepped = [&](const Point& lower) {
    ExactMesh mesh{PointSet({lower, {0, 0, 0}, {90, 0, 0}, {45, 45, 3}, {90, 90, 0}, {0, 90, 0}}),
                   {}};
    mesh.faces = stairs;
    return mesh;
  };
  for (const auto& meant : {std::vector<Simplex>{}, stairs}) {
    CHECK(reach_of(stepped({45, 45, 0}), square, 100, meant).error()->rule ==
          Rule::kPolygonNotTiled);
    CHECK(reach_of(stepped({40, 40, 0}), square, 100, meant)->squared_reach == 9);
  }
  // If the square is there as well, as it is, the vertex 4 is free.
  std::vector<Simplex> twice = fan;
  twice.insert(twice.end(), {{0, 1, 2}, {0, 2, 3}});
  CHECK(with({40, 40, 3}, twice)->squared_reach == 0);
  CHECK(with({40, 40, 3}, twice)->images.at({2, 0}).size() == 2);
  CHECK(with({40, 40, 0}, twice)->images.at({2, 0}).size() == 4);
  // Without it there are two ways to cut the square, which bound a flat tetrahedron: the lower one
  // is taken.
  const auto lower = with({40, 40, 50}, {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}, {0, 1, 4}});
  CHECK(lower.has_value());
  const PointSet bent({{0, 0, 1}, {90, 0, 0}, {90, 90, 1}, {0, 90, 0}});
  ExactMesh mesh{bent, {{0, 1, 2, 3}}};
  CHECK(reach_of(mesh, square, 100)->images.at({2, 0}) ==
        std::vector<Simplex>{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE("a vertex with two carriers makes a reach ambiguous") {
  // One is 4 from two segments, one is 4.5 off the first.
  const ExactMesh mesh{PointSet({{0, 0}, {80, 0}, {0, 60}, {4, 4}, {40, Rational(-9, 2)}}),
                       {{0, 4, 3}, {4, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  CHECK(reach_of(mesh, kTriangle, 25).error() == std::nullopt);
}

TEST_CASE("what is beyond the end of a segment is as far as its end") {
  const PiecewiseLinearInput segment{{{0, 0}, {80, 0}}, {{0, 1}}, {}, {}};
  ExactMesh mesh{PointSet({{0, 0}, {83, 4}, {100, 3}}), {}};
  mesh.faces = {{0, 1}, {1, 2}};
  CHECK(reach_of(mesh, segment, 100)->squared_reach == 25);
  mesh.points = PointSet({{0, 0}, {83, 4}, {-20, 3}});
  CHECK(reach_of(mesh, segment, 100)->squared_reach == 25);
}

TEST_CASE("a slit is an edge of the triangles") {
  const PiecewiseLinearInput slit{
      {{0, 0, 0}, {90, 0, 0}, {90, 90, 0}, {0, 90, 0}, {30, 45, 0}, {60, 45, 0}},
      {{4, 5}},
      {{{{0, 1, 2, 3}}, {}}},
      {}};
  ExactMesh mesh{PointSet(slit.points), {}};
  mesh.faces = {{0, 1, 4}, {1, 3, 4}, {0, 3, 4}, {1, 2, 5}, {2, 3, 5}, {1, 3, 5}, {4, 5}};
  CHECK(reach_of(mesh, slit, 25).error()->rule == Rule::kPolygonNotTiled);
  mesh.faces = {{0, 1, 4}, {1, 4, 5}, {0, 3, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}};
  CHECK(reach_of(mesh, slit, 25).has_value());
}

TEST_CASE("the images of two polygons share no triangle") {
  // The middle of their common edge is moved away from both, and a triangle lies along it.
  const PiecewiseLinearInput corner{{{0, 0, 0}, {0, 90, 0}, {90, 45, 0}, {0, 45, 90}},
                                    {},
                                    {{{{0, 1, 2}}, {}}, {{{0, 1, 3}}, {}}},
                                    {}};
  std::vector<Point> points = corner.points;
  points.push_back({-3, 45, -3});
  points[2][0] += 5;  // or the middle would be free
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  CHECK(reach_of(mesh, corner, 36).error()->rule == Rule::kImagesMeet);
  mesh.faces = {{0, 4, 2}, {1, 4, 2}, {0, 4, 3}, {1, 4, 3}};
  CHECK(reach_of(mesh, corner, 36)->squared_reach == 25);
}

}  // namespace
}  // namespace circumspect::definition
