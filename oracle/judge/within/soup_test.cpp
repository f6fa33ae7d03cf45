// The search for the least reach, and the verdict, against the definition: where cells of the
// domain are a few bits apart, vertices of the mesh a few bits from them and from each other, and
// edges and triangles any of those between these.
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/judge/within/held_to_definition_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::check {
namespace {

std::size_t below(Random& random, std::size_t count) { return random() % count; }

// Some bits, of either sign.
Rational noise(Random& random, long most) {
  return bits(static_cast<long>(below(random, static_cast<std::size_t>(2 * most + 1))) - most);
}

// Cells that are near each other without meeting, at acute angles, in one plane, or with a notch.
PiecewiseLinearInput drawn_cells(Random& random, std::size_t dimension) {
  const Rational near = bits(5 + static_cast<long>(below(random, 60)));
  PiecewiseLinearInput input;
  const std::size_t kind = below(random, dimension == 2 ? 3 : 6);
  if (dimension == 2) {
    input.points = {{0, 0}, {8, 0}, {0, 8}};
    input.segments = {{0, 1}, {1, 2}, {0, 2}};
    if (kind == 1) input.points[2] = {8, near};
    if (kind == 1) input.segments = {{0, 1}, {0, 2}};
    if (kind == 2) input.points = {{0, 0}, {8, 0}, {4, near}, {4, 8}};
    if (kind == 2) input.segments = {{0, 1}, {2, 3}};
    return input;
  }
  const auto polygon = [&](const std::vector<Vertex>& line) {
    input.polygons.push_back({{line}, {}});
  };
  switch (kind) {
    case 0:  // two segments that pass each other
      input.points = {{0, 0, 0}, {8, 0, 0}, {4, -4, near}, {4, 4, near}};
      input.segments = {{0, 1}, {2, 3}};
      break;
    case 1:  // a triangle below a vertex
      input.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {2, 2, near}};
      polygon({0, 1, 2});
      break;
    case 2:  // two triangles at one edge, flat or like the pages of a book
      input.points = {{0, 0, 0}, {8, 0, 0}, {4, 8, 0}, {4, below(random, 2) == 0 ? -8 : 8, near}};
      polygon({0, 1, 2});
      polygon({0, 1, 3});
      break;
    case 3:  // two triangles at one vertex
      input.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {-8, 0, near}, {0, -8, near}};
      polygon({0, 1, 2});
      polygon({0, 3, 4});
      break;
    case 4:  // a quadrilateral with a notch, which is two triangles
      input.points = {{0, 0, 0}, {8, 0, 0}, {2, 2, 0}, {0, 8, 0}};
      polygon({0, 1, 2, 3});
      break;
    default:  // a square, which is two triangles as well
      input.points = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
      polygon({0, 1, 2, 3});
  }
  return input;
}

// Its vertices moved, and some more: anywhere in a cell, or beside a vertex.
std::vector<Point> drawn_points(Random& random, const PiecewiseLinearInput& cells) {
  std::vector<Point> points = cells.points;
  const std::size_t own = points.size();
  for (std::size_t more = below(random, 3); more > 0; --more) {
    const Point &a = points[below(random, own)], &b = points[below(random, own)],
                &c = points[below(random, own)];
    const Rational s(static_cast<long>(below(random, 4)), 4), t = (1 - s) / 2;
    points.push_back(below(random, 3) == 0 ? a : a + s * (b - a) + t * (c - a));
  }
  const long most = 1 + static_cast<long>(below(random, 9));
  for (Point& point : points) {
    for (Rational& x : point) x += noise(random, most);
  }
  return points;
}

// In the plane edges. In space triangles, those of the cells among them, where a further vertex may
// be joined to their edges; and some edges.
std::vector<Simplex> drawn_faces(Random& random, const PiecewiseLinearComplex& complex,
                                 std::size_t points) {
  std::set<Simplex> faces;
  const auto any = [&] { return static_cast<Vertex>(below(random, points)); };
  for (const Simplex& segment : complex.segments) {
    if (below(random, 8) > 0) faces.insert(segment);
  }
  for (const Polygon& polygon : complex.polygons) {
    for (const Simplex& triangle : polygon.triangles) {
      const Vertex v = any();
      if (contains(triangle, v)) faces.insert(triangle);
      for (std::size_t i = 0; !contains(triangle, v) && i < 3; ++i) {
        faces.insert(sorted(with_vertex_replaced(triangle, i, v)));
      }
    }
  }
  for (std::size_t more = below(random, 5); more > 0; --more) {
    Simplex face = {any(), any()};
    if (!complex.polygons.empty()) face.push_back(any());
    if (!has_repeated_vertex(face)) faces.insert(sorted(face));
  }
  if (faces.size() > 1 && below(random, 4) == 0) faces.erase(std::next(faces.begin()));
  return {faces.begin(), faces.end()};
}

std::string said(const tl::expected<Verdict, NotJudged>& verdict) {
  if (!verdict) return "not judged";
  if (!verdict->holds()) return "fails";
  std::string text = "holds at " + to_string(verdict->within->squared_reach);
  const auto add = [&](const char* what, auto count) { text += what + std::to_string(count); };
  for (const Vertex v : verdict->extra_vertices->first) add(" beyond ", v);
  add(" on segments ", verdict->steiner_points->on_segments);
  add(" in polygons ", verdict->steiner_points->in_polygons);
  add(" in polyhedra ", verdict->steiner_points->in_polyhedra);
  add(" dangling ", verdict->dangling);
  add(" not compared ", verdict->within->not_compared);
  return text;
}

struct Soup {
  ExactMesh mesh;
  Domain domain;
  Markers markers = {};
};

// Two triangles at one edge, whose path leaves it behind them: the triangles between path and edge
// may be cut either way, and the edge itself belongs to both images. One of its ends may be so far
// off that only reaches will do at which it has such a path.
Soup drawn_book(Random& random) {
  PiecewiseLinearInput book;
  book.points = {{0, 0, 0}, {8, 0, 0}, {4, 8, 0}, {4, 6, 8}};
  book.polygons = {{{{0, 1, 2}}, {}}, {{{0, 1, 3}}, {}}};
  std::vector<Point> points = book.points;
  if (below(random, 2) == 0) points[0][2] = bits(9);
  for (const int x : {2, 6})
    points.push_back({x, noise(random, 2) - bits(4), noise(random, 2) - bits(4)});
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {0, 4, 5}, {0, 1, 5}, {0, 1, 4}, {1, 4, 5}};
  return {std::move(mesh), domain_of(book)};
}

// A square with a notch that is some bits wide. The image of the corner in the notch is beside it,
// and a vertex of the path of one side is as far off the plane: where the paths pass each other,
// the triangles about the corner cover the plane twice.
Soup drawn_notch(Random& random) {
  PiecewiseLinearInput notched;
  notched.points = {{0, 0, 0}, {8, 0, 0}, {8, 2, 0}, {2, 2, 0}, {8, 2 + bits(90), 0},
                    {8, 8, 0}, {0, 8, 0}};
  notched.polygons = {{{{0, 1, 2, 3, 4, 5, 6}}, {}}};
  std::vector<Point> points = notched.points;
  const long off = 2 + static_cast<long>(below(random, 20));
  points[3][1] -= bits(off);
  points.push_back({2 + Rational(1, 8), 2 + noise(random, 1), bits(off) + noise(random, 1)});
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = {{3, 4, 5}, {3, 5, 6}, {0, 3, 6}, {0, 1, 3}, {1, 2, 3}, {2, 3, 7}};
  return {std::move(mesh), domain_of(notched)};
}

// Three or four triangles at one edge, each with a vertex some bits from the edge. The image of the
// edge is moved about as far: seen along it, the triangles stand in the order of the pages or not.
Soup drawn_pages(Random& random) {
  PiecewiseLinearInput book;
  book.points = {{0, 0, 0}, {8, 0, 0}};
  // Seen along 0 1 from (4, -4), the first two are one behind the other.
  std::vector<Point> directions = {{0, 1, 0}, {0, 2, 1}, {0, -1, 0}, {0, 0, -1}};
  std::rotate(directions.begin(), directions.begin() + static_cast<long>(below(random, 4)),
              directions.end());
  const std::size_t pages = 3 + below(random, 2);
  for (std::size_t page = 0; page < pages; ++page) {
    book.points.push_back(Point{4, 0, 0} + Rational(8) * directions[page]);
    book.polygons.push_back({{{0, 1, static_cast<Vertex>(2 + page)}}, {}});
  }
  std::vector<Point> points = book.points;
  const long near = 8;
  Point moved = {0, bits(4), bits(-4)};
  if (below(random, 4) > 0) moved = {0, noise(random, near), noise(random, near)};
  for (std::size_t end : {0, 1}) points[end] = points[end] + moved;
  std::vector<Simplex> faces;
  for (std::size_t page = 0; page < pages; ++page) {
    const auto tip = static_cast<Vertex>(2 + page), inner = static_cast<Vertex>(points.size());
    points.push_back(Point{4, 0, 0} + bits(near) * directions[page]);
    faces.insert(faces.end(), {{0, 1, inner}, {1, tip, inner}, {0, tip, inner}});
  }
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = std::move(faces);
  return {std::move(mesh), domain_of(book)};
}

// A square with a vertex above it, one below, both or neither, and a flat tetrahedron or a gap
// between its halves above and those below, which are cut along different diagonals.
Soup drawn_wall(Random& random) {
  const std::size_t sides = below(random, 4);
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {3, 4, 9}, {4, 5, -7}};
  input.points.resize(sides / 2 == 1 ? 6 : 5);
  if (sides == 0) input.points.pop_back();
  input.polygons = {{{{0, 1, 2, 3}}, {}}};
  std::vector<Point> points = input.points;
  for (std::size_t v = 0; v < 4; ++v) points[v][2] += noise(random, 3);
  if (points[0][2] + points[2][2] == points[1][2] + points[3][2]) points[0][2] += bits(1);
  ExactMesh mesh{PointSet(points), {}};
  const bool has_flat = below(random, 4) > 0;
  if (has_flat) mesh.simplices.push_back({0, 1, 2, 3});
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};
  for (const Vertex apex : {4, 5}) {
    if (apex >= std::ssize(points) || (apex == 4 && sides == 2)) continue;
    for (Vertex v = 0; v < 4; ++v) input.polygons.push_back({{{v, (v + 1) % 4, apex}}, {}});
    const Vertex from = apex - 4;  // the diagonal is 0 2 or 1 3
    mesh.simplices.push_back({from, from + 1, from + 2, apex});
    mesh.simplices.push_back({from, from + 2, (from + 3) % 4, apex});
  }
  Domain domain = domain_of(input);
  domain.complex.kind = DomainKind::kEnclosed;
  return {std::move(mesh), std::move(domain)};
}

// A triangle and another one, which stands on an edge of it or nearly so.
Soup drawn_corner(Random& random) {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  input.polygons = {{{{0, 1, 2}}, {}}};
  std::vector<Point> points = input.points;
  points.push_back({below(random, 2) == 0 ? Rational(0) : noise(random, 2), 4, noise(random, 9)});
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  if (below(random, 2) == 0) mesh.faces.push_back({1, 2, 3});
  if (below(random, 2) == 0) mesh.faces.push_back({0, 1, 3});
  Markers markers;
  if (below(random, 2) == 0) markers.of_polygons = {1};
  for (const Simplex& face : mesh.faces) markers.of_triangles[face] = 1;
  return {std::move(mesh), domain_of(input), std::move(markers)};
}

Soup drawn_soup(Random& random, std::size_t dimension) {
  const std::size_t kind = dimension == 3 ? below(random, 12) : 5;
  if (kind == 0) return drawn_book(random);
  if (kind == 1) return drawn_notch(random);
  if (kind == 2) return drawn_pages(random);
  if (kind == 3) return drawn_wall(random);
  if (kind == 4) return drawn_corner(random);
  const PiecewiseLinearInput cells = drawn_cells(random, dimension);
  Domain domain = domain_of(cells);
  domain.complex.kind = DomainKind::kEnclosed;
  std::vector<Point> points = drawn_points(random, cells);
  while (!duplicates(points).empty()) points = drawn_points(random, cells);
  ExactMesh mesh{PointSet(std::move(points)), {}};
  mesh.faces = drawn_faces(random, domain.complex, mesh.points.size());
  return {std::move(mesh), std::move(domain)};
}

// How far a vertex is from a cell is how far it is from the nearest simplex of the cell.
void compare_distances(const Soup& soup, const Rational& squared_limit) {
  const std::vector<bool> used(soup.mesh.points.size(), true);
  const Cells cells(soup.domain.complex);
  Work work;
  const DomainPieces pieces(cells, work);
  const std::vector<RoundedPoint> rounded = pieces.rounding().points(soup.mesh.points.points());
  const Reaches reaches(soup.mesh, rounded, used, cells, pieces, squared_limit, 1);
  for (Vertex v = 0; soup.mesh.points.names(v); ++v) {
    const std::vector<ToCell>& near = reaches.of(v);
    // Of cells at a vertex that is near, see ToCell.
    if (!near.empty() && near.front().cell.dimension == 0) continue;
    for (const Cell cell : cells.all()) {
      std::optional<Rational> least;
      for (const Simplex& simplex : cells.simplices(cell)) {
        const Rational squared = squared_distance_to(
            coordinates(soup.domain.complex.points, simplex), soup.mesh.points[v]);
        if (!least || squared < *least) least = squared;
      }
      const auto found =
          std::find_if(near.begin(), near.end(), [&](const ToCell& to) { return to.cell == cell; });
      if (*least <= squared_limit) REQUIRE(found != near.end());
      if (found != near.end()) CHECK(found->squared() == *least);
    }
  }
}

// The same kinds of answers, reaches and images.
void compare_searches(const Soup& soup, const Rational& squared_limit,
                      std::map<ReachAnswer::Kind, int>& seen) {
  const std::vector<bool> used(soup.mesh.points.size(), true);
  const Cells cells(soup.domain.complex, soup.markers);
  const Regions regions(soup.domain.complex);
  Work work;
  const ReachAnswer quick = least_reach(soup.mesh, used, cells, regions, squared_limit, 1, work);
  const ReachAnswer slow =
      least_reach_by_definition(soup.mesh, used, cells, regions, squared_limit);
  ++seen[slow.kind];
  CHECK(quick.kind == slow.kind);
  if (slow.kind != ReachAnswer::Kind::kFound) return;
  CHECK(to_string(quick.squared_reach) == to_string(slow.squared_reach));
  CHECK(text_of_images(quick.images) == text_of_images(slow.images));
}

// If there must be no Steiner points, each is named once.
void check_forbidden(const Soup& soup, const Rational& squared_limit) {
  const auto verdict = judge_within(Claim::kPlcTriangulation, soup.mesh, soup.domain, squared_limit,
                                    {}, nullptr, nullptr, soup.markers);
  if (!verdict || !verdict->within || !verdict->steiner_points) return;
  const auto named = verdict->tallies().find(Rule::kSteinerForbidden);
  CHECK((named == verdict->tallies().end() ? 0 : named->second.count) ==
        verdict->steiner_points->count());
}

// Each fault that is counted has a witness. Images that meet do so in a face of the mesh; and what
// is missing is missing from a cell of the domain.
void check_witnesses(const tl::expected<Verdict, NotJudged>& verdict, const Soup& soup) {
  if (!verdict) return;
  std::size_t counted = 0;
  for (const auto& tally : verdict->tallies()) counted += tally.second.count;
  CHECK(counted == verdict->violations().size());
  std::vector<Simplex> of_mesh = soup.mesh.faces;
  of_mesh.insert(of_mesh.end(), soup.mesh.simplices.begin(), soup.mesh.simplices.end());
  for (const Violation& violation : verdict->violations()) {
    const Witness& witness = violation.witness;
    if (violation.rule == Rule::kImagesMeet) {
      CHECK(!has_repeated_vertex(*witness.face));
      CHECK(std::any_of(of_mesh.begin(), of_mesh.end(),
                        [&](const Simplex& of) { return has_face(of, *witness.face); }));
    }
    const bool is_missing = violation.rule == Rule::kSegmentMissing ||
                            violation.rule == Rule::kDomainVertexMissing ||
                            violation.rule == Rule::kPolygonNotTiled;
    if (is_missing) CHECK((witness.domain_cell || witness.polygon));
  }
}

// However its vertices are numbered, a mesh holds at the same distance, or does not.
void check_renumbered(const tl::expected<Verdict, NotJudged>& verdict, const Soup& soup,
                      const Rational& squared_limit) {
  Markers markers{{}, soup.markers.of_polygons};
  for (const auto& [triangle, marker] : soup.markers.of_triangles) {
    markers.of_triangles[renumbered(triangle, soup.mesh.points.size())] = marker;
  }
  const auto again = judge_within(Claim::kSteinerTriangulation, renumbered(soup.mesh), soup.domain,
                                  squared_limit, {}, nullptr, nullptr, markers);
  REQUIRE(again.has_value() == verdict.has_value());
  if (!verdict) return;
  CHECK(again->holds() == verdict->holds());
  if (!verdict->holds()) return;
  CHECK(to_string(again->within->squared_reach) == to_string(verdict->within->squared_reach));
  CHECK(again->dangling == verdict->dangling);
}

void hold_soups_to_definition(std::size_t dimension, unsigned long cases) {
  std::map<ReachAnswer::Kind, int> seen;
  int held = 0;
  for (unsigned long seed = 0; seed < cases; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Soup soup = drawn_soup(random, dimension);
    if (soup.markers.of_triangles.empty()) {
      soup.markers = random_markers(soup.mesh, soup.domain.complex, random);
    }
    const Rational limit = bits(static_cast<long>(below(random, 40)));
    const std::vector<bool> used(soup.mesh.points.size(), true);
    const Cells cells(soup.domain.complex);
    if (!is_sound(soup.mesh) ||
        !is_small_enough_for_definition(soup.mesh, used, cells, limit * limit, 8)) {
      continue;
    }
    compare_distances(soup, limit * limit);
    compare_searches(soup, limit * limit, seen);
    const auto quick =
        judge_within(Claim::kSteinerTriangulation, soup.mesh, soup.domain, limit * limit,
                     {.max_violations = 0}, nullptr, nullptr, soup.markers);
    const auto slow =
        judge_within(Claim::kSteinerTriangulation, soup.mesh, soup.domain, limit * limit,
                     {.by = By::kDefinition}, nullptr, nullptr, soup.markers);
    CHECK(said(quick) == said(slow));
    check_forbidden(soup, limit * limit);
    check_witnesses(quick, soup);
    check_renumbered(quick, soup, limit * limit);
    const bool are_triangles = soup.mesh.simplices.empty() && dimension == 3 &&
                               std::all_of(soup.mesh.faces.begin(), soup.mesh.faces.end(),
                                           [](const Simplex& face) { return face.size() == 3; });
    if (quick && quick->holds() && are_triangles) {
      CHECK(quick->dangling == soup.mesh.faces.size());
    }
    held += quick && quick->holds() ? 1 : 0;
  }
  MESSAGE("dimension " << dimension << ": found " << seen[ReachAnswer::Kind::kFound] << " none "
                       << seen[ReachAnswer::Kind::kNone] << " ambiguous "
                       << seen[ReachAnswer::Kind::kAmbiguous] << " holds " << held);
  CHECK(seen[ReachAnswer::Kind::kFound] > 0);
  CHECK(seen[ReachAnswer::Kind::kNone] > 0);
  CHECK(seen[ReachAnswer::Kind::kAmbiguous] > 0);
  CHECK(held > 0);
}

TEST_CASE(
    "an ambiguous distance at which all cells have images is passed over, and not forgotten") {
  // Two triangles at the edge 0 1, and vertex 4 between them: 5 bits from either, 10 from the edge.
  PiecewiseLinearInput book;
  book.points = {{0, 0, 0}, {8, 0, 0}, {4, 8, 0}, {4, 6, 8}};
  book.polygons = {{{{0, 1, 2}}, {}}, {{{0, 1, 3}}, {}}};
  std::vector<Point> points = book.points;
  points[2][2] = bits(6);
  points.push_back({4, bits(9), bits(4)});
  points.push_back({3, -5, -5});
  points.push_back({5, -5, -5});
  Soup soup{{PointSet(points), {}}, domain_of(book)};
  soup.mesh.faces = {{0, 1, 2}, {0, 1, 3}, {4, 5, 6}};
  for (const By by : {By::kLemma, By::kDefinition}) {
    const auto judged = [&](const Rational& distance) {
      return said(judge_within(Claim::kSteinerTriangulation, soup.mesh, soup.domain,
                               distance * distance, {.by = by}));
    };
    CHECK(judged(bits(5)) == "fails");
    CHECK(judged(bits(6)) == "not judged");
    CHECK(judged(bits(20)) == "not judged");
  }
}

TEST_CASE("of nearly coincident cells and any faces near them the definition says the same") {
  hold_soups_to_definition(2, 200);
  hold_soups_to_definition(3, 340);
}

}  // namespace
}  // namespace circumspect::check
