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

// Every point is in a triangle, so nothing but what is wrong tells that this is no complex of them.
TEST_CASE("an octahedron with a diagonal, a vertex that is none, or two polygons in one") {
  PiecewiseLinearInput octahedron;
  octahedron.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Vertex x : {0, 1}) {
    for (const Vertex y : {2, 3}) {
      for (const Vertex z : {4, 5}) octahedron.polygons.push_back({{{x, y, z}}, {}});
    }
  }
  const auto same = [&](const auto& change) {
    PiecewiseLinearInput changed = octahedron;
    change(changed);
    const auto slow = validated(changed);
    const auto quick = validated_domain(changed);
    return slow ? quick && are_equal(*quick, *slow) : !quick && quick.error() == slow.error();
  };
  CHECK(same([](auto&) {}));
  for (const Simplex& segment : {Simplex{0, 2}, {0, 1}, {0, 6}, {-1, 0}, {0}, {0, 2, 4}, {0, 0}}) {
    CAPTURE(segment);
    CHECK(same([&](auto& changed) { changed.segments = {segment}; }));
  }
  for (const Vertex v : {-1, 6}) {
    CHECK(same([&](auto& changed) { changed.polygons[3].lines[0][1] = v; }));
  }
  CHECK(same([](auto& changed) { changed.polygons[3].lines[0].pop_back(); }));
  CHECK(same([](auto& changed) { changed.polygons[3].hole_seeds = {{0, 0, 0}}; }));
  // The upper half as it was, and the middle as one polygon of four corners.
  CHECK(same([](auto& changed) {
    std::erase_if(changed.polygons, [](const auto& one) { return one.lines[0][2] == 5; });
    changed.points.pop_back();
    changed.polygons.push_back({{{0, 2, 1, 3}}, {}});
  }));
  CHECK(same([](auto& changed) { changed.points[5] = changed.points[4]; }));
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

std::optional<Verdict> held(Claim claim, const ExactMesh& exact, const Domain& domain,
                            std::size_t max_violations = 20) {
  Mesh mesh = in_rows(exact);
  auto& coordinates = std::get<Rows<double>>(mesh.coordinates);
  for (double& x : coordinates.values()) x = x == 0 ? -0.0 : x;
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
  const ExactMesh with_centre = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  const Domain cube = domain_of_facets(with_centre, [](std::size_t uses) { return uses == 1; });
  CHECK(is_seen(Claim::kSteinerCdt, with_centre, cube));
  CHECK(!is_seen(Claim::kCdt, with_centre, cube));  // one Steiner point
  CHECK(!is_seen(Claim::kPlcTriangulation, with_centre, cube));
  // What is listed beside.
  ExactMesh listed = mesh;
  const Simplex wall = facet_uses(mesh.simplices).front().facet;
  listed.faces = {{wall[1], wall[0], wall[2]}, {wall[2], wall[0]}};
  CHECK(is_seen(Claim::kCdt, listed, every_facet));
  for (const Simplex& other :
       {Simplex{0, 35}, {0, 99}, {0, Vertex{1} << 40}, {0, -1}, {0, 1, 35}, {0, 0}, {0}}) {
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
  for (const int away : {2, 9}) {
    PiecewiseLinearInput two;
    two.points = {{0, 0, 0}, {0, 4, 0}, {away, 2, 1}, {away, 2, -1}, {-1, 2, 1}, {-1, 2, -1}};
    const ExactMesh wedge{PointSet(two.points), {{0, 1, 2, 3}, {0, 1, 4, 5}}};
    CHECK(is_seen(Claim::kCdt, wedge, surface(wedge)));
    CHECK(is_seen(Claim::kConformingDelaunay, wedge, surface(wedge)) == (away == 9));
    CHECK(judge_domain(Claim::kConformingDelaunay, wedge, surface(wedge)).holds() == (away == 9));
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

// Six tetrahedra in each of a row of cubes. In half of the rows the corners are moved a little, so
// that no two facets are in one plane, and some are not locally Delaunay.
ExactMesh uneven_row(std::mt19937& random, const KeepCell& keep) {
  const ExactMesh even = grid({0, 1, 2, 3}, {0, 1}, {0, 1}, keep);
  std::vector<Point> points = even.points.points();
  const long most = random() % 2 == 0 ? 0 : 2;
  for (Point& point : points) {
    for (Rational& x : point) x += Rational(static_cast<long>(random()) % (most + 1)) / 16;
  }
  return {PointSet(std::move(points)), even.simplices};
}

Simplex any_facet(std::mt19937& random, const ExactMesh& mesh) {
  return facet_opposite(mesh.simplices[random() % mesh.simplices.size()], random() % 4);
}

// The boundary of some of the tetrahedra, and at times one facet more or less; a vertex or a
// segment that is in no polygon; a hole.
PiecewiseLinearInput drawn_domain(std::mt19937& random, const ExactMesh& whole,
                                  const std::vector<Simplex>& filled) {
  PiecewiseLinearInput input;
  std::map<Vertex, Vertex> vertex_of;
  const auto own = [&](Simplex simplex) {
    for (Vertex& v : simplex) {
      const auto [found, is_new] = vertex_of.try_emplace(v, vertex_of.size());
      if (is_new) input.points.push_back(whole.points[v]);
      v = found->second;
    }
    return simplex;
  };
  const std::size_t inner = random() % 2 == 0 ? 0 : 4;
  for (const auto group : ByFacet(facet_uses(filled))) {
    const bool is_wall = group.size() == 1 || random() % 8 < inner;
    if (is_wall) input.polygons.push_back({{own(group.front().facet)}, {}});
  }
  const auto seldom = [&] { return random() % 6 == 0; };
  if (seldom()) input.polygons.pop_back();
  if (seldom()) {
    const Simplex facet = own(sorted(any_facet(random, whole)));
    const auto is_it = [&](const auto& one) { return sorted(one.lines[0]) == sorted(facet); };
    if (std::none_of(input.polygons.begin(), input.polygons.end(), is_it))
      input.polygons.push_back({{facet}, {}});
  }
  if (seldom()) own({static_cast<Vertex>(random() % whole.points.size())});
  if (seldom()) {
    const Simplex facet = any_facet(random, whole);
    input.segments.push_back(own({facet[0], facet[1]}));
  }
  if (seldom()) {
    const Simplex& simplex = whole.simplices[random() % whole.simplices.size()];
    input.hole_seeds.push_back(barycentre(whole.points, simplex));
  }
  if (seldom()) input.kind = DomainKind::kHull;
  return input;
}

// Whatever is a wall, and whatever the mesh has: what is seen is what the exact checkers say.
TEST_CASE("what is seen of a mesh that holds is so of every domain") {
  std::mt19937 random(20261127);
  constexpr std::array kClaims = {Claim::kPlcTriangulation, Claim::kSteinerTriangulation,
                                  Claim::kCdt, Claim::kSteinerCdt, Claim::kConformingDelaunay};
  std::map<Claim, std::size_t> seen;
  std::size_t others = 0;
  for (int round = 0; round < 1000; ++round) {
    const ExactMesh whole = uneven_row(random, every_cell);
    const auto some = [&](std::size_t share) {
      std::vector<Simplex> kept = whole.simplices;
      std::erase_if(kept, [&](const Simplex&) { return random() % 16 >= share; });
      return kept;
    };
    const std::vector<Simplex> filled = some(random() % 2 == 0 ? 16 : 12);
    if (filled.empty()) continue;
    const auto complex = validated(drawn_domain(random, whole, filled), 1);
    if (!complex) continue;
    // The mesh has the points of its simplices, and at times one more.
    ExactMesh mesh{whole.points, random() % 4 == 0 ? some(15) : filled};
    std::vector<Point> points;
    std::vector<Vertex> number(whole.points.size(), -1);
    const auto own = [&](Vertex v) {
      Vertex& of_v = number[static_cast<std::size_t>(v)];
      if (of_v < 0) points.push_back(whole.points[v]);
      return of_v < 0 ? of_v = static_cast<Vertex>(points.size()) - 1 : of_v;
    };
    for (Simplex& simplex : mesh.simplices) {
      for (Vertex& v : simplex) v = own(v);
    }
    if (random() % 8 == 0) own(static_cast<Vertex>(random() % whole.points.size()));
    mesh.points = PointSet(points);
    if (mesh.simplices.empty() || mesh.points.dimension() < 3) continue;
    if (random() % 4 == 0) mesh.faces.push_back(any_facet(random, mesh));
    if (random() % 4 == 0) mesh.faces.push_back(facet_opposite(any_facet(random, mesh), 0));
    const Claim claim = kClaims[random() % kClaims.size()];
    ++(is_seen(claim, mesh, {*complex}) ? seen[claim] : others);
  }
  CHECK(seen.size() == kClaims.size());
  // Without a tetrahedron that may have no facet in a wall.
  const ExactMesh cube = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  const Domain surface = domain_of_facets(cube, [](std::size_t uses) { return uses == 1; });
  for (std::size_t s = 0; s < cube.simplices.size(); ++s) {
    ExactMesh mesh = cube;
    mesh.simplices.erase(mesh.simplices.begin() + static_cast<std::ptrdiff_t>(s));
    CHECK(!is_seen(Claim::kSteinerTriangulation, mesh, surface));
  }
  CHECK(others > 100);
}

}  // namespace
}  // namespace circumspect::check
