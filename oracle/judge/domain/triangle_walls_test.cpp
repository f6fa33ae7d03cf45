// What is seen on doubles of domains of triangles and of their meshes is what the exact checkers
// say.
#include "oracle/judge/domain/triangle_walls.hpp"

#include <random>

#include <doctest/doctest.h>

#include "kernel/complex/by_facet.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/fast/triangle_complex.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {
namespace {

// A few triangles with corners on a grid of two cells along each axis: a shape in which almost
// everything is degenerate. `aslant` moves it off the grid, and keeps what lies in one plane there.
PiecewiseLinearInput triangles_on_grid(std::mt19937& random, std::size_t count, bool aslant) {
  std::map<std::array<int, 3>, Vertex> vertex_at;
  PiecewiseLinearInput input;
  while (input.polygons.size() < count) {
    std::vector<Vertex> corners;
    for (int i = 0; i < 3; ++i) {
      std::array<int, 3> at;
      for (int& x : at) x = static_cast<int>(random() % 3);
      const auto [found, is_new] = vertex_at.try_emplace(at, vertex_at.size());
      corners.push_back(found->second);
      if (!is_new) continue;
      const auto [x, y, z] = at;
      input.points.push_back(aslant ? Point{Rational(1000003 * x + 7 * y + z) / 1024,
                                            Rational(999983 * y + 3 * x - 5 * z) / 4096,
                                            Rational(17 * z - 2 * x + 11 * y) / 512}
                                    : Point{x, y, z});
    }
    input.polygons.push_back({{corners}, {}});
  }
  return input;
}

bool are_equal(const PiecewiseLinearComplex& a, const PiecewiseLinearComplex& b) {
  return a.points.points() == b.points.points() && a.segments == b.segments && a.kind == b.kind &&
         a.hole_seeds == b.hole_seeds &&
         std::equal(a.polygons.begin(), a.polygons.end(), b.polygons.begin(), b.polygons.end(),
                    [](const Polygon& p, const Polygon& q) {
                      return p.vertices == q.vertices && p.segments == q.segments &&
                             p.hole_seeds == q.hole_seeds && p.axes == q.axes &&
                             p.triangles == q.triangles;
                    });
}

bool are_surely_a_complex(const PiecewiseLinearInput& input) {
  const Numbers numbers = numbers_of(input.points, 3);
  std::vector<std::array<std::int32_t, 3>> triangles;
  for (const PolygonLines& polygon : input.polygons) {
    const auto& line = polygon.lines.front();
    triangles.push_back({static_cast<std::int32_t>(line[0]), static_cast<std::int32_t>(line[1]),
                         static_cast<std::int32_t>(line[2])});
  }
  return fast::are_surely_a_complex(std::get<Rows<double>>(numbers).values(), triangles);
}

TEST_CASE("triangles are a complex iff they are a valid domain that adopts nothing") {
  std::mt19937 random(20261122);
  std::size_t valid = 0, invalid = 0;
  for (int round = 0; round < 6000; ++round) {
    const PiecewiseLinearInput input =
        triangles_on_grid(random, 1 + random() % 3, random() % 2 == 0);
    const auto slow = validated(input, 1);
    const auto quick = validated_domain(input, 1);
    REQUIRE(quick.has_value() == slow.has_value());
    if (slow) {
      CHECK(are_equal(*quick, *slow));
    } else {
      CHECK(quick.error() == slow.error());
    }
    const auto repeats = [](const PolygonLines& polygon) {
      return has_repeated_vertex(polygon.lines.front());
    };
    if (std::any_of(input.polygons.begin(), input.polygons.end(), repeats)) continue;
    const bool is_complex = slow && adoptions(input, *slow).empty();
    CHECK(are_surely_a_complex(input) == is_complex);
    ++(is_complex ? valid : invalid);
  }
  CHECK(valid > 500);
  CHECK(invalid > 500);
}

TEST_CASE("what else belongs to a domain is left to the exact checkers") {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  for (const Simplex& facet : {Simplex{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
    input.polygons.push_back({{facet}, {}});
  }
  const auto same = [](const PiecewiseLinearInput& changed) {
    const auto slow = validated(changed);
    const auto quick = validated_domain(changed);
    if (!slow) return !quick && quick.error() == slow.error();
    return quick && are_equal(*quick, *slow);
  };
  CHECK(same(input));
  input.segments = {{3, 0}};  // an edge
  CHECK(same(input));
  input.hole_seeds = {{1, 1, 1}};
  CHECK(same(input));
  PiecewiseLinearInput changed = input;
  changed.hole_seeds = {{1, 1, 0}};  // on a wall
  CHECK(same(changed));
  changed = input;
  changed.points.push_back({1, 1, 0});  // an isolated vertex, adopted
  CHECK(same(changed));
  changed.points.back() = {0, 0, 4};  // listed twice
  CHECK(same(changed));
  changed = input;
  changed.points.insert(changed.points.end(), {{1, 1, 1}, {1, 1, 2}});
  changed.segments.push_back({4, 5});
  CHECK(same(changed));
  changed.segments.back() = {0, 7};
  CHECK(same(changed));
  changed = input;
  changed.points[3] = {0, 0, Rational(4) / 3};
  CHECK(same(changed));
  changed = input;
  changed.polygons.front().lines.push_back({0});
  CHECK(same(changed));
}

TEST_CASE("triangles that all share a vertex are too many to hold against each other") {
  PiecewiseLinearInput fan;
  constexpr int kCount = 1500;
  fan.points = {{0, 0, 1}};
  for (int i = 0; i < kCount; ++i) {
    fan.points.push_back({i - kCount / 2, (i - kCount / 2) * (i - kCount / 2), 0});
    if (i > 0) fan.polygons.push_back({{{0, i, i + 1}}, {}});
  }
  CHECK(!are_surely_a_complex(fan));
  CHECK(validated_domain(fan).has_value());
  fan.points.resize(60);
  fan.polygons.resize(58);
  CHECK(are_surely_a_complex(fan));
}

// The domain whose polygons are some facets of a mesh.
Domain domain_of_facets(const ExactMesh& mesh, const std::function<bool(std::size_t)>& takes) {
  PiecewiseLinearInput input;
  std::map<Vertex, Vertex> vertex_of;
  for (const auto group : ByFacet(facet_uses(mesh.simplices))) {
    if (!takes(group.size())) continue;
    Simplex polygon = group.front().facet;
    for (Vertex& v : polygon) {
      const auto [found, is_new] = vertex_of.try_emplace(v, vertex_of.size());
      if (is_new) input.points.push_back(mesh.points[v]);
      v = found->second;
    }
    input.polygons.push_back({{polygon}, {}});
  }
  auto complex = validated(input);
  REQUIRE(complex.has_value());
  return {std::move(*complex)};
}

std::optional<Verdict> held(Claim claim, const ExactMesh& exact, const Domain& domain,
                            std::size_t max_violations = 20) {
  const Mesh mesh = in_rows(exact);
  const auto& coordinates = std::get<Rows<double>>(mesh.coordinates);
  const auto known = exact_facts(claim, exact, domain);
  REQUIRE(known.has_value());
  Options options;
  options.max_violations = max_violations;
  const fast::MeshView<3, std::int32_t> view{
      coordinates.values(), {}, mesh.simplices.rows<std::int32_t>()->values()};
  return held_by_facets(claim, view, exact.faces, domain, *known, options);
}

// The verdict is that of the exact checkers, if there is one. Is there?
bool is_seen(Claim claim, const ExactMesh& mesh, const Domain& domain,
             std::size_t max_violations = 20) {
  const auto verdict = held(claim, mesh, domain, max_violations);
  if (!verdict) return false;
  Options options;
  options.max_violations = max_violations;
  CHECK(text_of(*verdict) == text_of(judge_exactly(claim, mesh, &domain, options)));
  CHECK(verdict->holds());
  return true;
}

TEST_CASE("meshes that hold, by all claims") {
  const ExactMesh mesh = grid({0, 1, 2, 3}, {0, 1, 2}, {0, 1, 2}, every_cell);
  const Domain surface = domain_of_facets(mesh, [](std::size_t uses) { return uses == 1; });
  CHECK(is_seen(Claim::kSteinerTriangulation, mesh, surface));
  CHECK(is_seen(Claim::kSteinerTriangulation, mesh, surface, 1));
  CHECK(is_seen(Claim::kSteinerTriangulation, mesh, surface, 0));
  CHECK(is_seen(Claim::kSteinerCdt, mesh, surface));
  CHECK(!is_seen(Claim::kCdt, mesh, surface));  // Steiner points
  CHECK(is_seen(Claim::kConformingDelaunay, mesh, surface));
  const Domain every_facet = domain_of_facets(mesh, [](std::size_t) { return true; });
  for (const Claim claim :
       {Claim::kPlcTriangulation, Claim::kSteinerTriangulation, Claim::kCdt, Claim::kSteinerCdt}) {
    CHECK(is_seen(claim, mesh, every_facet));
  }
  // What is listed beside.
  ExactMesh listed = mesh;
  const Simplex wall = facet_uses(mesh.simplices).front().facet;
  listed.faces = {{wall[1], wall[0], wall[2]}, {wall[2], wall[0]}};
  CHECK(is_seen(Claim::kCdt, listed, every_facet));
  for (const Simplex& other : {Simplex{0, 35}, {0, 99}, {0, -1}, {0, 1, 35}, {0, 0}, {0}}) {
    listed.faces = {other};
    CHECK(!is_seen(Claim::kCdt, listed, every_facet));
  }
}

TEST_CASE("a room within a room, filled or not") {
  const std::vector<int> ticks = {0, 1, 2, 3};
  const ExactMesh full = grid(ticks, ticks, ticks, every_cell);
  const ExactMesh hollow =
      grid(ticks, ticks, ticks,
           [](std::size_t x, std::size_t y, std::size_t z) { return x != 1 || y != 1 || z != 1; });
  Domain rooms = domain_of_facets(hollow, [](std::size_t uses) { return uses == 1; });
  const Claim claim = Claim::kCdt;
  CHECK(is_seen(claim, full, rooms));
  CHECK(!is_seen(claim, hollow, rooms));
  rooms.complex.hole_seeds = {{Rational(3) / 2, Rational(5) / 3, Rational(4) / 3}};
  CHECK(!is_seen(claim, full, rooms));
  CHECK(is_seen(claim, hollow, rooms));
}

TEST_CASE("what is wrong is left to the exact checkers") {
  const ExactMesh mesh = grid({0, 1, 2, 3}, {0, 1, 2}, {0, 1, 2}, every_cell);
  const auto surface = [](const ExactMesh& of) {
    return domain_of_facets(of, [](std::size_t uses) { return uses == 1; });
  };
  const Claim claim = Claim::kSteinerTriangulation;
  ExactMesh fewer = mesh;
  fewer.simplices.pop_back();
  CHECK(!is_seen(claim, fewer, surface(mesh)));
  CHECK(is_seen(claim, fewer, surface(fewer)));
  CHECK(!is_seen(claim, mesh, surface(fewer)));
  // A room that is a hole, though there is a mesh in it.
  Domain hole = surface(mesh);
  hole.complex.hole_seeds = {{Rational(1) / 3, Rational(1) / 5, Rational(1) / 7}};
  CHECK(!is_seen(claim, mesh, hole));
  hole.complex.kind = DomainKind::kHull;
  CHECK(!is_seen(claim, mesh, hole));
  // A point that no simplex has, and one that is moved.
  std::vector<Point> points = mesh.points.points();
  points.push_back({Rational(1) / 2, Rational(1) / 4, Rational(1) / 8});
  CHECK(!is_seen(claim, {PointSet(points), mesh.simplices}, surface(mesh)));
  points.pop_back();
  points[0] = {Rational(-1) / 4, 0, 0};
  CHECK(!is_seen(claim, {PointSet(points), mesh.simplices}, surface(mesh)));
  // A facet off the walls that is not locally Delaunay.
  points = mesh.points.points();
  std::replace(points.begin(), points.end(), Point{1, 1, 1},
               Point{Rational(5) / 4, Rational(5) / 4, Rational(9) / 8});
  const ExactMesh moved{PointSet(points), mesh.simplices};
  CHECK(is_seen(claim, moved, surface(mesh)));
  CHECK(!is_seen(Claim::kSteinerCdt, moved, surface(mesh)));
  CHECK(!is_seen(Claim::kConformingDelaunay, moved, surface(mesh)));
  // Two tetrahedra that share an edge: a ball at the boundary reaches beyond it, to a vertex or
  // not.
  for (const int height : {2, 9}) {
    PiecewiseLinearInput two;
    two.points = {{0, 0, 0}, {0, 4, 0}, {4, 2, 1}, {4, 2, -1}, {-4, 2, height}, {-4, 2, -1}};
    const ExactMesh wedge{PointSet(two.points), {{0, 1, 2, 3}, {0, 1, 4, 5}}};
    CHECK(is_seen(Claim::kCdt, wedge, surface(wedge)));
    CHECK(is_seen(Claim::kConformingDelaunay, wedge, surface(wedge)) ==
          judge_domain(Claim::kConformingDelaunay, wedge, surface(wedge)).holds());
  }
  // A dangling wall, and a segment within.
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-1, -1, -1}};
  for (const Simplex& facet : {Simplex{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
    input.polygons.push_back({{facet}, {}});
  }
  const ExactMesh one{PointSet({input.points.begin(), input.points.end() - 1}), {{0, 1, 2, 3}}};
  CHECK(!is_seen(claim, {PointSet(input.points), one.simplices}, {*validated(input)}));
  input.polygons.push_back({{{0, 1, 4}}, {}});
  CHECK(!is_seen(claim, {PointSet(input.points), one.simplices, {}, 0, {}, {{0, 1, 4}}},
                 {*validated(input)}));
  input.points.pop_back();
  input.polygons.pop_back();
  CHECK(is_seen(claim, one, {*validated(input)}));
}

}  // namespace
}  // namespace circumspect::check
