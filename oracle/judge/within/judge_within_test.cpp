// The cases that the definition was made for: docs/theory/within.md.
#include "oracle/judge/within/judge_within.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "kernel/complex/polytope.hpp"
#include "oracle/judge/within/answers_test.hpp"
#include "oracle/judge/within/held_to_definition_test.hpp"
#include "oracle/judge/within/hull_faces.hpp"
#include "oracle/judge/within/hull_walls.hpp"

namespace circumspect::check {
namespace {

// A box of 4 × 4 × 4, meshed with vertices in the middles of edges along x.
MovedMesh box_with_steiner_points() {
  return {grid({0, 2, 4}, {0, 4}, {0, 4}, every_cell), domain_of(cuboid({0, 0, 0}, {4, 4, 4}))};
}
MovedMesh square_with_steiner_points() {
  return {grid({0, 2, 4}, {0, 2, 4}, {0}, every_cell), domain_of(cuboid({0, 0}, {4, 4}))};
}

MovedMesh soup(const std::vector<Point>& domain_points, const std::vector<Simplex>& polygons,
               const std::vector<Point>& points, const std::vector<Simplex>& faces) {
  PiecewiseLinearInput input;
  input.points = domain_points;
  for (const Simplex& corners : polygons) input.polygons.push_back({{corners}, {}});
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = faces;
  return {mesh, domain_of(input)};
}

}  // namespace

TEST_CASE("within: a mesh for which the claim holds is moved by nothing, whatever the distance") {
  for (const Rational& distance : {Rational(0), bits(1), Rational(1)}) {
    CHECK(answer(box_with_steiner_points(), kTriangulates, distance) == "holds 0");
    CHECK(answer(square_with_steiner_points(), kTriangulates, distance) == "holds 0");
  }
}

TEST_CASE("within: vertices of segments, of polygons and of the domain that were moved") {
  for (const Point& at : {Point{2, 0, 0}, Point{0, 0, 0}, Point{4, 4, 0}}) {
    MovedMesh box = box_with_steiner_points();
    box.mesh = moved_vertex(box.mesh, at, {0, bits(3), bits(4)});
    CHECK(both_answers(box) == "holds 5");
    CHECK(answer(box, kTriangulates, bits(5)) == "holds 5");
    CHECK(answer(box, kTriangulates, bits(5) - bits(1) / 1000).starts_with("fails"));
    CHECK(answer(box, kTriangulates, 0).starts_with("fails"));
  }
  MovedMesh square = square_with_steiner_points();
  square.mesh = moved_vertex(square.mesh, {2, 0}, {0, bits(7)});
  CHECK(both_answers(square) == "holds 7");
}

TEST_CASE("within: what is wrong besides is named by its rule") {
  MovedMesh box = box_with_steiner_points();
  box.mesh = moved_vertex(box.mesh, {2, 0, 0}, {0, bits(3), bits(4)});
  const ExactMesh whole = box.mesh;
  for (std::size_t s = 0; s < whole.simplices.size(); ++s) {
    box.mesh = whole;
    box.mesh.simplices.erase(box.mesh.simplices.begin() + static_cast<std::ptrdiff_t>(s));
    CHECK(both_answers(box).starts_with("fails domain."));
  }
  box.mesh = whole;
  box.mesh.simplices.push_back(box.mesh.simplices.front());
  CHECK(answer(box) == "fails complex.duplicate-simplex");
  box.mesh = whole;  // a tetrahedron upon a face
  std::vector<Point> points = whole.points.points();
  points.push_back({1, 1, -1});
  box.mesh = with_points(whole, points);
  const Vertex far = static_cast<Vertex>(points.size()) - 1;
  box.mesh.simplices.push_back({vertex_at(whole.points, {0, 0, 0}),
                                vertex_at(whole.points, {2 + 0, bits(3), bits(4)}),
                                vertex_at(whole.points, {2, 4, 0}), far});
  CHECK(both_answers(box) == "fails domain.outside");
}

TEST_CASE("within: of simplices and faces that are not sound the exact claim says all there is") {
  const MovedMesh box = box_with_steiner_points();
  const ExactMesh moved = moved_vertex(box.mesh, {2, 0, 0}, {0, bits(3), bits(4)});
  const auto n = static_cast<Vertex>(moved.points.size());
  const Simplex first = moved.simplices.front();
  const auto same = [&](const ExactMesh& mesh, const KnownBeside& known) {
    const auto verdict = judge_within(kTriangulates, mesh, box.domain, 1, {}, known);
    const Verdict exactly = judge_exactly(kTriangulates, mesh, &box.domain);
    return verdict && !verdict->holds() && !verdict->within &&
           text_of(*verdict) == text_of(exactly);
  };
  for (const Simplex& unsound : {Simplex{first[0], first[1], first[2], n},
                                 {first[0], first[0], first[1], first[2]},
                                 {first[0], first[1], first[2]},
                                 first}) {
    ExactMesh mesh = moved;
    mesh.simplices.push_back(unsound);
    CHECK(same(mesh, {}));
  }
  const auto facts = exact_facts(kTriangulates, moved, box.domain);
  REQUIRE(facts.has_value());
  for (const Simplex& unsound : {Simplex{first[0], n}, {first[0], first[0]}}) {
    ExactMesh mesh = moved;
    mesh.faces = {unsound};
    CHECK(same(mesh, {}));
    CHECK(same(mesh, &*facts));
  }
}

TEST_CASE("within: a mesh that holds as it stands may be too large to be moved by definition") {
  const MovedMesh box{grid({0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, {0, 4}, every_cell),
                      domain_of(cuboid({0, 0, 0}, {4, 4, 4}))};
  const auto by_definition = [&](const ExactMesh& mesh) {
    return judge_within(kTriangulates, mesh, box.domain, 1, {.by = By::kDefinition});
  };
  const auto whole = by_definition(box.mesh);
  REQUIRE(whole.has_value());
  CHECK(whole->holds());
  CHECK(!by_definition(moved_vertex(box.mesh, {2, 0, 0}, {0, bits(3), bits(4)})));
  // So many points of a convex hull that not every plane through three of them is tried.
  PiecewiseLinearInput hull;
  for (int x = 0; x < 7; ++x) {
    for (int y = 0; y < 7; ++y) {
      for (int z = 0; z < 7; ++z) hull.points.push_back({x, y, z});
    }
  }
  hull.kind = DomainKind::kHull;
  ExactMesh one{PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), {{0, 1, 2, 3}}};
  const auto of_many =
      judge_within(kTriangulates, one, domain_of(hull), 1, {.by = By::kDefinition});
  REQUIRE(!of_many);
  CHECK(of_many.error().reason.starts_with("By definition every plane through three vertices is"));
}

TEST_CASE("within: what an image lacks is named in the words of the domain") {
  // An edge is listed from corner to corner, and the tetrahedra cross it.
  PiecewiseLinearInput input = cuboid({0, 0, 0}, {4, 4, 4});
  const PointSet corners(input.points);
  const Simplex diagonal = {vertex_at(corners, {0, 0, 0}), vertex_at(corners, {4, 4, 4})};
  input.segments.push_back(diagonal);
  MovedMesh box{box_with_steiner_points().mesh, domain_of(input)};
  const PointSet& points = box.mesh.points;
  box.mesh.faces = {{vertex_at(points, {4, 4, 4}), vertex_at(points, {0, 0, 0})}};
  box.mesh = moved_vertex(box.mesh, {2, 0, 0}, {0, bits(3), bits(4)});
  const auto verdict = judge_within(kTriangulates, box.mesh, box.domain, kSquaredLimit);
  REQUIRE(verdict);
  REQUIRE(verdict->tallies().contains(Rule::kSegmentMissing));
  const Witness& witness = verdict->violations().front().witness;
  CHECK(witness.domain_cell == sorted(diagonal));
  CHECK(!witness.polygon);
}

TEST_CASE("within: Steiner points in walls are Steiner points") {
  MovedMesh box = box_with_steiner_points();
  box.mesh = moved_vertex(box.mesh, {2, 0, 0}, {0, bits(3), bits(4)});
  CHECK(answer(box, Claim::kPlcTriangulation) == "fails domain.steiner-forbidden");
  CHECK(answer(box, Claim::kCdt).starts_with("fails domain.steiner-forbidden"));
  const auto verdict =
      judge_within(kTriangulates, box.mesh, box.domain, Rational(100 * kBit) * (100 * kBit));
  REQUIRE(verdict);
  CHECK(verdict->steiner_points->on_segments == 4);
  CHECK(verdict->steiner_points->in_polygons == 0);
}

TEST_CASE("within: a flat tetrahedron at a wall belongs to the inside") {
  // One diagonal of the floor dips inward, so that there is room for a tetrahedron below it.
  MovedMesh box = {grid({0, 4}, {0, 4}, {0, 4}, every_cell),
                   domain_of(cuboid({0, 0, 0}, {4, 4, 4}))};
  box.mesh = moved_vertex(box.mesh, {0, 0, 0}, {0, 0, bits(3)});
  box.mesh = moved_vertex(box.mesh, {4, 4, 0}, {0, 0, bits(3)});
  CHECK(both_answers(box) == "holds 3");
  const auto at = [&](int x, int y, const Rational& z) {
    return vertex_at(box.mesh.points, {x, y, z});
  };
  const Simplex flat = {at(0, 0, bits(3)), at(4, 0, 0), at(4, 4, bits(3)), at(0, 4, 0)};
  box.mesh.simplices.push_back(flat);
  CHECK(both_answers(box) == "holds 3");
  // On the other side there is no room: it overlaps what is there.
  MovedMesh other = {grid({0, 4}, {0, 4}, {0, 4}, every_cell),
                     domain_of(cuboid({0, 0, 0}, {4, 4, 4}))};
  other.mesh = moved_vertex(other.mesh, {0, 0, 0}, {0, 0, -bits(3)});
  other.mesh = moved_vertex(other.mesh, {4, 4, 0}, {0, 0, -bits(3)});
  CHECK(both_answers(other) == "holds 3");
  other.mesh.simplices.push_back(
      {vertex_at(other.mesh.points, {0, 0, -bits(3)}), vertex_at(other.mesh.points, {4, 0, 0}),
       vertex_at(other.mesh.points, {4, 4, -bits(3)}), vertex_at(other.mesh.points, {0, 4, 0})});
  CHECK(both_answers(other).starts_with("fails complex.overlap"));
}

TEST_CASE(
    "within: a flat tetrahedron at a wall that has the inside on both sides is on one of them") {
  const std::vector<int> two = {0, 4, 8};
  MovedMesh boxes = {
      grid({0, 4}, {0, 4}, two, every_cell),
      domain_of(cells_domain({0, 4}, {0, 4}, two, every_cell, [](std::size_t) { return true; }))};
  CHECK(boxes.domain.complex.polygons.size() == 11);
  // The cube above turned over, so that its diagonal in the wall is the other one; then the
  // diagonal below dips, and there is room.
  std::vector<Point> points = boxes.mesh.points.points();
  for (Simplex& simplex : boxes.mesh.simplices) {
    bool above = false;
    for (const Vertex v : simplex) above |= boxes.mesh.points[v][2] > 4;
    if (!above) continue;
    for (Vertex& v : simplex) {
      const Point& p = boxes.mesh.points[v];
      v = vertex_at(boxes.mesh.points, {4 - p[0], p[1], p[2]});
    }
  }
  boxes.mesh = moved_vertex(boxes.mesh, {0, 0, 4}, {0, 0, -bits(3)});
  boxes.mesh = moved_vertex(boxes.mesh, {4, 4, 4}, {0, 0, -bits(3)});
  CHECK(both_answers(boxes).starts_with("fails domain.uncovered"));
  boxes.mesh.simplices.push_back(
      {vertex_at(boxes.mesh.points, {0, 0, 4 - bits(3)}), vertex_at(boxes.mesh.points, {4, 0, 4}),
       vertex_at(boxes.mesh.points, {4, 4, 4 - bits(3)}), vertex_at(boxes.mesh.points, {0, 4, 4})});
  CHECK(both_answers(boxes) == "holds 3");
}

// The images are those of the definition.
void check_images(const ExactMesh& mesh, const Domain& domain, const Markers& markers) {
  const Cells cells(domain.complex, markers);
  const std::vector<bool> used = match_vertices(mesh, domain.complex).used;
  Work work;
  const ReachAnswer quick =
      least_reach(mesh, used, cells, domain.regions(), kSquaredLimit, 1, work);
  const ReachAnswer slow =
      least_reach_by_definition(mesh, used, cells, domain.regions(), kSquaredLimit);
  CHECK(text_of_images(quick.images) == text_of_images(slow.images));
}

// The diagonals of the sides do not end in the vertices of the wall that are moved down.
TEST_CASE("within: markers say which facets are a polygon, where there is a choice") {
  // Two cubes with a wall between them, and a flat tetrahedron in the wall. From above a vertex is
  // near, which sees two of its facets inside their circumballs.
  PiecewiseLinearInput input =
      cells_domain({0, 4}, {0, 4}, {0, 4, 8}, every_cell, [](std::size_t) { return true; });
  input.points.push_back({2, 2, 5});
  const auto is_wall = [&](const std::vector<Vertex>& corners) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](Vertex v) { return input.points[static_cast<std::size_t>(v)][2] == 4; });
  };
  std::partition(input.polygons.begin(), input.polygons.end(),
                 [&](const auto& one) { return is_wall(one.lines.front()); });
  const Domain domain = domain_of(input);
  ExactMesh mesh = grid({0, 4}, {0, 4}, {0, 4}, every_cell);
  std::vector<Point> points = mesh.points.points();
  for (const Point& p : std::vector<Point>{{0, 0, 8}, {4, 0, 8}, {0, 4, 8}, {4, 4, 8}, {2, 2, 5}}) {
    points.push_back(p);
  }
  mesh = with_points(mesh, points);
  const auto at = [&](int x, int y, int z) { return vertex_at(mesh.points, {x, y, z}); };
  const Vertex low[] = {at(0, 0, 4), at(4, 0, 4), at(4, 4, 4), at(0, 4, 4)};
  const Vertex high[] = {at(0, 0, 8), at(4, 0, 8), at(4, 4, 8), at(0, 4, 8)};
  const std::vector<Simplex> upper_facets = {sorted({low[0], low[1], low[3]}),
                                             sorted({low[1], low[2], low[3]})};
  std::vector<Simplex> boundary = upper_facets;
  add_sides_and_top(low, high, boundary);
  for (const Simplex& triangle : boundary) {
    mesh.simplices.push_back(with_apex(triangle, at(2, 2, 5)));
  }
  mesh.simplices.push_back({low[0], low[1], low[2], low[3]});
  mesh = moved_vertex(mesh, {0, 0, 4}, {0, 0, -bits(3)});
  mesh = moved_vertex(mesh, {4, 4, 4}, {0, 0, -bits(3)});
  Markers markers;
  for (const Polygon& polygon : domain.complex.polygons) {
    markers.of_polygons.push_back(is_wall(polygon.vertices) ? 5 : 0);
  }
  REQUIRE(markers.of_polygons.front() == 5);
  const auto not_local = [&] {
    check_images(mesh, domain, markers);
    const auto verdict = judge_within(Claim::kSteinerCdt, mesh, domain, kSquaredLimit, {}, nullptr,
                                      nullptr, markers);
    REQUIRE(verdict);
    return verdict->tallies().contains(Rule::kConstrainedFacetNotLocal)
               ? verdict->tallies().at(Rule::kConstrainedFacetNotLocal).count
               : 0;
  };
  const std::size_t lowest = not_local();
  markers.of_triangles[upper_facets[0]] = 5;
  CHECK(not_local() == lowest);  // one of them is not an image
  markers.of_triangles[upper_facets[1]] = 6;
  CHECK(not_local() == lowest);
  markers.of_triangles[upper_facets[1]] = 5;
  CHECK(not_local() + 2 == lowest);
  for (const std::size_t opposite : {std::size_t{1}, std::size_t{3}}) {
    markers.of_triangles[sorted({low[0], low[2], low[opposite]})] = 5;
  }
  CHECK(not_local() == lowest);  // none of the four is an image
  markers.of_polygons.assign(markers.of_polygons.size(), 0);
  CHECK(not_local() == lowest);
}

TEST_CASE("within: three polygons at one segment, in another order") {
  // Two of them stand at a tiny angle; each has a vertex on its upper side, from which the order
  // near the segment follows. The third is far away.
  const auto book = [](long of_first, long of_second) {
    const Rational e = bits(10);
    const std::vector<Point> domain = {{0, 0, 0}, {0, 0, 4}, {8, 0, 0}, {8, 8 * e, 4}, {-4, 1, 2}};
    std::vector<Point> points = domain;
    points.push_back({1, bits(of_first), Rational(7, 2)});
    points.push_back({1, bits(of_second), 4});
    return soup(domain, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, points,
                {{0, 1, 5}, {0, 5, 2}, {0, 1, 6}, {0, 6, 3}, {0, 1, 4}});
  };
  CHECK(both_answers(book(0, 10), bits(10)) == "holds 0");
  CHECK(both_answers(book(2, 8), bits(10)).starts_with("holds"));
  CHECK(both_answers(book(6, 4), bits(10)) == "fails domain.images-meet");
}

TEST_CASE("within: images that intersect though their cells do not") {
  // A segment leaves a triangle steeply; its first vertex was moved into the triangle.
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {4, 4, 4}};
  input.polygons = {{{{0, 1, 2}}, {}}};
  input.segments = {{0, 3}};
  const auto with_vertex = [&](const Point& at) {
    std::vector<Point> points = input.points;
    points.push_back(at);
    ExactMesh mesh{PointSet(points), {}};
    mesh.faces = {{0, 1, 2}, {0, 4}, {3, 4}};
    return MovedMesh{mesh, domain_of(input)};
  };
  CHECK(both_answers(with_vertex({bits(4), bits(4), bits(4)}), bits(3)) == "holds 0");
  CHECK(both_answers(with_vertex({bits(40), bits(40), bits(38)}), bits(3)).starts_with("holds"));
  CHECK(both_answers(with_vertex({bits(2), bits(2), 0}), bits(3)) == "fails complex.overlap");
}

TEST_CASE("within: dangling polygons that are not flat any more are counted") {
  MovedMesh sheet =
      soup({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3}},
           {{0, 0, bits(1)}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK(both_answers(sheet) == "holds 1");
  const auto verdict = judge_within(Claim::kCdt, sheet.mesh, sheet.domain, kSquaredLimit);
  REQUIRE(verdict);
  CHECK(verdict->holds());
  CHECK(verdict->within->not_compared == 1);
  sheet.mesh = moved_vertex(sheet.mesh, {0, 0, bits(1)}, {bits(1), 0, -bits(1)});
  const auto flat = judge_within(Claim::kCdt, sheet.mesh, sheet.domain, kSquaredLimit);
  CHECK((flat && flat->holds() && flat->within->not_compared == 0));
}

TEST_CASE("within: a lone vertex of the domain outside what is filled has no simplex") {
  MovedMesh box = box_with_steiner_points();
  PiecewiseLinearInput input = cuboid({0, 0, 0}, {4, 4, 4});
  input.points.push_back({9, 9, 9});
  box.domain = domain_of(input);
  std::vector<Point> points = box.mesh.points.points();
  points.push_back({9, 9, 9});
  box.mesh = with_points(box.mesh, points);
  CHECK(both_answers(box) == "holds 0");
  box.mesh = moved_vertex(box.mesh, {2, 0, 0}, {0, bits(3), bits(4)});
  CHECK(both_answers(box) == "holds 5");
  box.mesh = moved_vertex(box.mesh, {9, 9, 9}, {bits(1), 0, 0});
  CHECK(both_answers(box) == "fails domain.vertex-missing");
}

TEST_CASE("within: holes and regions keep the side that they had") {
  // A square ring, meshed exactly but for a vertex of the hole; then the hole filled.
  const auto keep = [](std::size_t i, std::size_t j, std::size_t) { return i != 1 || j != 1; };
  PiecewiseLinearInput input = cells_domain({0, 4, 8, 12}, {0, 4, 8, 12}, {0}, keep);
  input.hole_seeds = {{6, 6}};
  MovedMesh ring = {grid({0, 4, 8, 12}, {0, 4, 8, 12}, {0}, keep), domain_of(input)};
  ring.mesh = moved_vertex(ring.mesh, {4, 4}, {bits(2), 0});
  CHECK(both_answers(ring) == "holds 2");
  ring.mesh = grid({0, 4, 8, 12}, {0, 4, 8, 12}, {0}, every_cell);
  ring.mesh = moved_vertex(ring.mesh, {4, 4}, {bits(2), 0});
  CHECK(both_answers(ring) == "fails domain.outside");
}

TEST_CASE("within: a cave keeps its inside, whichever of its corners has moved") {
  const std::vector<int> ticks = {0, 4, 8, 12};
  const auto keep = [](std::size_t i, std::size_t j, std::size_t k) {
    return i != 1 || j != 1 || k != 1;
  };
  PiecewiseLinearInput input = cells_domain(ticks, ticks, ticks, keep);
  input.hole_seeds = {{6, 6, 6}};
  const MovedMesh shell = {grid(ticks, ticks, ticks, keep), domain_of(input)};
  const ExactMesh filled = grid(ticks, ticks, ticks, every_cell);
  for (const Point& corner : {Point{4, 4, 4}, {8, 4, 8}, {8, 8, 8}}) {
    CHECK(answer({moved_vertex(shell.mesh, corner, {bits(2), 0, 0}), shell.domain}) == "holds 2");
    CHECK(answer({moved_vertex(filled, corner, {0, 0, bits(2)}), shell.domain}) ==
          "fails domain.outside");
  }
}

TEST_CASE("within: a convex hull whose faces nobody lists") {
  PiecewiseLinearInput input = cuboid({0, 0, 0}, {4, 4, 4});
  input.kind = DomainKind::kHull;
  // All faces, none, and all but the floor and the edges that it alone has.
  const std::vector<PolygonLines> faces = input.polygons;
  for (const std::size_t count : {faces.size(), std::size_t{0}, faces.size() - 1}) {
    input.polygons.assign(faces.end() - static_cast<std::ptrdiff_t>(count), faces.end());
    MovedMesh box = {box_with_steiner_points().mesh, domain_of(input)};
    CHECK(both_answers(box) == "holds 0");
    box.mesh = moved_vertex(box.mesh, {2, 0, 0}, {0, bits(3), bits(4)});
    CHECK(both_answers(box) == "holds 5");
    box.mesh = moved_vertex(box.mesh, {4, 4, 4}, {bits(1), 0, 0});
    box.mesh = moved_vertex(box.mesh, {4, 4, 0}, {-bits(1), 0, 0});
    CHECK(both_answers(box) == "holds 5");
    CHECK(answer(box, Claim::kPlcTriangulation) == "fails domain.steiner-forbidden");
    CHECK(both_answers(box, bits(4)).starts_with("fails domain."));
    box.mesh.simplices.erase(box.mesh.simplices.begin());
    CHECK(both_answers(box).starts_with("fails domain."));
  }
}

TEST_CASE("within: in the plane the points on an edge of a convex hull are on its boundary") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {0, 2}, {0, 4}, {3, 4}, {4, 4}, {4, 1}, {4, 0}, {1, 0}, {1, 1}};
  input.kind = DomainKind::kHull;
  const Domain square = domain_of(input);
  const auto lines = hull_faces(square.complex.points);
  CHECK(lines == facets_by_definition(square.complex.points, all_vertices(square.complex.points)));
  CHECK(lines.size() == 4);
  CHECK(with_hull_walls(square.complex, lines).segments.size() == 8);
  MovedMesh moved = {
      {square.complex.points,
       {{0, 7, 8}, {7, 6, 8}, {6, 5, 8}, {5, 4, 8}, {4, 3, 8}, {3, 2, 8}, {2, 1, 8}, {1, 0, 8}}},
      square};
  CHECK(both_answers(moved) == "holds 0");
  // A vertex rounded in, one out: their triangles are not a hull any more.
  moved.mesh = moved_vertex(moved.mesh, {4, 1}, {-bits(2), 0});
  moved.mesh = moved_vertex(moved.mesh, {0, 2}, {-bits(1), 0});
  CHECK(both_answers(moved) == "holds 2");
  moved.mesh.simplices.pop_back();
  CHECK(both_answers(moved).starts_with("fails domain."));
}

TEST_CASE("within: points on a line have a convex hull that fills nothing") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {4, 0}};
  input.segments = {{0, 1}};
  input.kind = DomainKind::kHull;
  ExactMesh mesh{PointSet({{0, 0}, {2, bits(1)}, {4, 0}}), {}};
  mesh.faces = {{0, 1}, {1, 2}};
  CHECK(both_answers({mesh, domain_of(input)}) == "holds 1");
}

}  // namespace circumspect::check
