// The claim `periodic-delaunay`: by lemma and by definition it holds of the same meshes that a
// lattice repeats, with and without planted faults. Proof: docs/theory/questions.md.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/periodic/judge_periodic.hpp"
#include "oracle/judge/periodic/unfolded.hpp"
#include "oracle/model/listed_mesh_test.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties::periodic {
namespace {

using generators::Dice;

// As programs list it.
struct ListedMesh {
  std::vector<Point> points = {};
  std::vector<Simplex> cells = {};
  Periodic how = {};
};

std::vector<Simplex> offsets_around(std::size_t d) {
  std::vector<Simplex> all = {{}};
  for (std::size_t axis = 0; axis < d; ++axis) {
    std::vector<Simplex> longer;
    for (const Simplex& begun : all) {
      for (const Vertex multiple : {0, -1, 1}) {
        longer.push_back(begun);
        longer.back().push_back(multiple);
      }
    }
    all = std::move(longer);
  }
  return all;
}

// The cells of a finite part whose first vertex is where it was listed: one of all that the lattice
// makes of it. If the part was too small, the mesh is wrong, and both judges have to say so.
ListedMesh drawn_mesh(Dice& dice, std::size_t d) {
  ListedMesh mesh;
  for (std::size_t i = 0; i < d; ++i) {
    mesh.how.lattice.emplace_back();
    for (std::size_t axis = 0; axis < d; ++axis) {
      mesh.how.lattice[i].emplace_back(i == axis ? dice.within(4L, 6L) : dice.within(-1L, 1L));
    }
  }
  const Copies moves{.lattice = mesh.how.lattice};
  const std::size_t count = 1 + dice.below(d == 2 ? 3 : 2);
  for (std::size_t i = 0; i < count; ++i) {
    Point point;
    for (std::size_t axis = 0; axis < d; ++axis) {
      point.push_back(dice.within(0L, 1024L) / Rational(256));
    }
    mesh.points.push_back(point);
  }
  std::vector<Point> copies;
  std::vector<Simplex> offsets;
  for (const Simplex& offset : offsets_around(d)) {
    for (const Point& point : mesh.points) {
      copies.push_back(point + moves.shift(offset));
      offsets.push_back(offset);
    }
  }
  if (!duplicates(copies).empty()) return drawn_mesh(dice, d);
  const PointSet part(copies);
  const Triangulation whole = delaunay::bowyer_watson(part);
  for (const Simplex& cell : whole.simplices()) {
    std::vector<std::pair<Vertex, Simplex>> corners;
    for (const Vertex v : cell) {
      const auto place = static_cast<std::size_t>(v);
      corners.emplace_back(static_cast<Vertex>(place % count), offsets[place]);
    }
    const auto first = *std::min_element(corners.begin(), corners.end());
    if (first.second != Simplex(d, 0)) continue;
    mesh.cells.emplace_back();
    mesh.how.offsets.emplace_back();
    for (const auto& [point, offset] : corners) {
      mesh.cells.back().push_back(point);
      Simplex& row = mesh.how.offsets.back();
      row.insert(row.end(), offset.begin(), offset.end());
    }
  }
  return mesh;
}

// A grid of integers, whose cubes are cut along their diagonals: everywhere many points are on one
// sphere.
ListedMesh grid_mesh(Dice& dice, std::size_t d) {
  ListedMesh mesh;
  std::vector<Vertex> sides;
  Vertex count = 1;
  for (std::size_t axis = 0; axis < d; ++axis) {
    sides.push_back(static_cast<Vertex>(1 + (d == 2 ? dice.below(2) : 0)));
    count *= sides.back();
    mesh.how.lattice.emplace_back(d, 0);
    mesh.how.lattice[axis][axis] = Rational(to_integer(sides.back()));
  }
  const auto corner_at = [&](Vertex cube, const Simplex& step) {
    std::pair<Vertex, Simplex> corner{0, {}};
    Vertex stride = 1;
    for (std::size_t axis = 0; axis < d; ++axis) {
      const Vertex at = cube / stride % sides[axis] + step[axis];
      corner.first += at % sides[axis] * stride;
      corner.second.push_back(at / sides[axis]);
      stride *= sides[axis];
    }
    return corner;
  };
  for (Vertex cube = 0; cube < count; ++cube) {
    Point point;
    Vertex rest = cube;
    for (std::size_t axis = 0; axis < d; ++axis) {
      point.emplace_back(to_integer(rest % sides[axis]));
      rest /= sides[axis];
    }
    mesh.points.push_back(point);
    Simplex order = first_subset(d);
    do {
      mesh.cells.emplace_back();
      mesh.how.offsets.emplace_back();
      Simplex step(d, 0);
      for (std::size_t i = 0; i <= d; ++i) {
        if (i > 0) step[static_cast<std::size_t>(order[i - 1])] = 1;
        const auto [vertex, offset] = corner_at(cube, step);
        mesh.cells.back().push_back(vertex);
        Simplex& row = mesh.how.offsets.back();
        row.insert(row.end(), offset.begin(), offset.end());
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return mesh;
}

// Calls `change` with each corner's vertex and its offset.
template <class Change>
void for_each_corner(ListedMesh& mesh, const Change& change) {
  const std::size_t d = mesh.how.lattice.size();
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (std::size_t i = 0; i < mesh.cells[c].size(); ++i) {
      change(mesh.cells[c][i], std::span(mesh.how.offsets[c]).subspan(i * d, d));
    }
  }
}

// The same mesh by another basis of the lattice, other points of the same orbits, and cells that
// are listed elsewhere.
void list_otherwise(Dice& dice, ListedMesh& mesh) {
  const std::size_t d = mesh.how.lattice.size();
  const std::size_t changed = dice.below(d), other = (changed + 1 + dice.below(d - 1)) % d;
  const Vertex times = dice.within(-1L, 1L);
  mesh.how.lattice[changed] =
      mesh.how.lattice[changed] + Rational(to_integer(times)) * mesh.how.lattice[other];
  for_each_corner(
      mesh, [&](Vertex, std::span<Vertex> offset) { offset[other] -= times * offset[changed]; });
  const Copies moves{.lattice = mesh.how.lattice};
  const auto moved = static_cast<Vertex>(dice.below(mesh.points.size()));
  Simplex way;
  for (std::size_t i = 0; i < d; ++i) way.push_back(dice.within(-1L, 1L));
  Point& point = mesh.points[static_cast<std::size_t>(moved)];
  point = point + moves.shift(way);
  for_each_corner(mesh, [&](Vertex v, std::span<Vertex> offset) {
    for (std::size_t i = 0; v == moved && i < d; ++i) offset[i] -= way[i];
  });
  Simplex& row = mesh.how.offsets[dice.below(mesh.cells.size())];
  for (std::size_t i = 0; i < row.size(); ++i) row[i] += way[i % d];
}

void add_cell(ListedMesh& mesh, const Simplex& cell, const Simplex& offsets) {
  mesh.cells.push_back(cell);
  mesh.how.offsets.push_back(offsets);
}

// Another mesh of the same lattice lies over it.
void add_second_sheet(Dice& dice, ListedMesh& mesh) {
  const ListedMesh first = mesh;
  Point way;
  for (std::size_t axis = 0; axis < mesh.how.lattice.size(); ++axis) {
    way.push_back(dice.within(1L, 3L) / Rational(5));
  }
  const auto count = static_cast<Vertex>(first.points.size());
  for (const Point& point : first.points) mesh.points.push_back(point + way);
  for (std::size_t c = 0; c < first.cells.size(); ++c) {
    Simplex cell = first.cells[c];
    for (Vertex& v : cell) v += count;
    add_cell(mesh, cell, first.how.offsets[c]);
  }
}

void break_once(Dice& dice, ListedMesh& mesh) {
  if (mesh.cells.empty()) return;
  const std::size_t d = mesh.how.lattice.size();
  const std::size_t c = dice.below(mesh.cells.size());
  const std::size_t corner = dice.below(mesh.cells[c].size());
  switch (dice.below(10)) {
    case 0:
      mesh.how.offsets[c][dice.below(mesh.how.offsets[c].size())] += dice.below(2) == 0 ? 1 : -1;
      return;
    case 1:
      mesh.cells[c][corner] = static_cast<Vertex>(dice.below(mesh.points.size() + 1));
      return;
    case 2:
      mesh.cells.erase(mesh.cells.begin() + static_cast<std::ptrdiff_t>(c));
      mesh.how.offsets.erase(mesh.how.offsets.begin() + static_cast<std::ptrdiff_t>(c));
      return;
    case 3:
      return add_cell(mesh, mesh.cells[c], mesh.how.offsets[c]);
    case 4: {
      Point& point = mesh.points[dice.below(mesh.points.size())];
      for (Rational& x : point) x += dice.within(-2L, 2L) / Rational(2);
      return;
    }
    case 5:  // what was Delaunay is sheared
      mesh.how.lattice[0][d - 1] += dice.within(1L, 4L);
      return;
    case 6: {  // a point that no cell names, the first or the last
      mesh.points.push_back(Rational(1, 3) * mesh.points[0]);
      mesh.points.back()[0] += Rational(1, 7);
      if (dice.below(2) == 0) return;
      const auto last = static_cast<Vertex>(mesh.points.size() - 1);
      std::swap(mesh.points.front(), mesh.points.back());
      for (Simplex& cell : mesh.cells) std::replace(cell.begin(), cell.end(), Vertex{0}, last);
      return;
    }
    case 7: {  // it is turned over
      Simplex& row = mesh.how.offsets[c];
      const auto first = row.begin(), second = first + static_cast<std::ptrdiff_t>(d);
      std::swap_ranges(first, second, second);
      std::swap(mesh.cells[c][0], mesh.cells[c][1]);
      return;
    }
    case 8:
      if (mesh.cells[c].size() <= 2) return;
      mesh.cells[c].pop_back();
      mesh.how.offsets[c].resize(d * mesh.cells[c].size());
      return;
    default:
      add_second_sheet(dice, mesh);
  }
}

// Of cells that do not fit together nobody asks what they cover, and of those that cover something
// twice nobody asks about balls.
void check_stages(const Verdict& verdict) {
  const auto breaks = [&](Rule rule) { return verdict.tallies().contains(rule); };
  const bool do_not_fit =
      breaks(Rule::kNotClosed) || breaks(Rule::kFacetOverused) || breaks(Rule::kOverlap);
  RC_ASSERT(!do_not_fit || !breaks(Rule::kCoveredTwice));
  RC_ASSERT(!(do_not_fit || breaks(Rule::kCoveredTwice)) || !breaks(Rule::kFacetNotLocal));
}

// The second cell, moved as the witness says.
std::vector<Point> second_cell(const Witness& witness, const ExactMesh& mesh,
                               const Copies& copies) {
  RC_ASSERT(witness.simplices.size() == 2);
  RC_ASSERT(witness.values.size() >= copies.lattice.size());
  std::vector<Point> corners = coordinates(mesh.points, witness.simplices[1]);
  for (std::size_t i = 0; i < copies.lattice.size(); ++i) {
    for (Point& corner : corners) corner = corner + witness.values[i].value * copies.lattice[i];
  }
  return corners;
}

// Cells are named by their places, too; where two have common points, the second one is moved
// there, and one cell is not named twice.
void check_witness(const Violation& violation, const ExactMesh& mesh, const Copies& copies) {
  const Witness& witness = violation.witness;
  if (!witness.places.empty()) RC_ASSERT(witness.places.size() == witness.simplices.size());
  for (std::size_t i = 0; i < witness.places.size(); ++i) {
    RC_ASSERT(mesh.simplices[witness.places[i]] == witness.simplices[i]);
  }
  const bool is_covered_twice = violation.rule == Rule::kCoveredTwice;
  if (!is_covered_twice && violation.rule != Rule::kOverlap) return;
  std::vector<Point> corners = second_cell(witness, mesh, copies);
  RC_ASSERT(witness.places[0] != witness.places[1] ||
            corners != coordinates(mesh.points, witness.simplices[0]));
  for (const Vertex v : is_covered_twice ? Simplex() : *witness.face) {
    RC_ASSERT(std::count(corners.begin(), corners.end(), mesh.points[v]) == 1);
  }
  if (!is_covered_twice) return;
  RC_ASSERT(*witness.point == barycentre(coordinates(mesh.points, witness.simplices[0])));
  if (std::count(corners.begin(), corners.end(), *witness.point) == 1) return;
  corners.push_back(*witness.point);
  const Configuration points(corners);
  const auto last = static_cast<Vertex>(corners.size() - 1);
  for (const int sign : barycentric_signs(points, first_subset(corners.size() - 1), last)) {
    RC_ASSERT(sign >= 0);
  }
}

struct Outcomes {
  std::map<Rule, std::size_t> broken = {};
  std::size_t held = 0, refused = 0;
};

void compare(std::size_t d, int inputs, Outcomes& seen) {
  CHECK(holds("by lemma as by definition", inputs, [&, d] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    ListedMesh mesh = dice.below(4) == 0 ? grid_mesh(dice, d) : drawn_mesh(dice, d);
    list_otherwise(dice, mesh);
    for (std::size_t faults = dice.below(3); faults > 0; --faults) break_once(dice, mesh);
    Mesh listed;
    listed.coordinates = numbers_of(mesh.points, d);
    listed.simplices = IndexLists(mesh.cells);
    if (!check::fault_of_periodic(listed, mesh.how).empty()) {
      ++seen.refused;
      return;
    }
    const Mesh unfolded = check::unfolded(listed, mesh.how);
    const bool oriented = dice.below(4) == 0;
    const Verdict by_lemma =
        check::judge_periodic(unfolded, {.oriented = oriented, .max_violations = 0});
    const Verdict by_definition =
        check::judge_periodic(unfolded, {.by = check::By::kDefinition, .oriented = oriented});
    RC_ASSERT(by_lemma.holds() == by_definition.holds());
    seen.held += by_lemma.holds() ? 1 : 0;
    for (const auto& [rule, tally] : by_lemma.tallies()) ++seen.broken[rule];
    check_stages(by_lemma);
    const ExactMesh whole = exact(unfolded);
    for (const Violation& violation : by_lemma.violations()) {
      check_witness(violation, whole, *unfolded.copies);
    }
  }));
}

TEST_CASE(
    "periodic-delaunay: by lemma and by definition it holds of the same meshes in the plane") {
  Outcomes seen;
  compare(2, 2400, seen);
  CHECK(occurs(seen.held, 100));
  CHECK(occurs(seen.refused));
  for (const Rule rule : {Rule::kUnknownVertex, Rule::kWrongDimension, Rule::kRepeatedVertex,
                          Rule::kDegenerateSimplex, Rule::kDuplicateSimplex, Rule::kOrientation,
                          Rule::kNotClosed, Rule::kFacetOverused, Rule::kOverlap,
                          Rule::kUnusedPoint, Rule::kCoveredTwice, Rule::kFacetNotLocal}) {
    CAPTURE(identifier(rule));
    CHECK(occurs(seen.broken[rule]));
  }
}

// The definition is slow there: few inputs, and every rule comes up only among many.
TEST_CASE("periodic-delaunay: by lemma and by definition it holds of the same meshes in space") {
  Outcomes seen;
  compare(3, 80, seen);
  CHECK(occurs(seen.held, 8));
  CHECK(occurs(seen.broken.size(), 8));
}

std::set<Rule> broken_by_definition(const std::vector<Point>& points,
                                    const std::vector<Simplex>& cells, const Periodic& how) {
  const Mesh listed = listed_mesh(points, cells);
  std::set<Rule> broken;
  const Verdict verdict =
      check::judge_periodic(check::unfolded(listed, how), {.by = check::By::kDefinition});
  for (const auto& [rule, tally] : verdict.tallies()) broken.insert(rule);
  return broken;
}

TEST_CASE("periodic-delaunay: a triangle fits beside its copies iff its area is half a cell's") {
  for (Vertex ax = -2; ax <= 2; ++ax) {
    for (Vertex ay = -2; ay <= 2; ++ay) {
      for (Vertex bx = -2; bx <= 2; ++bx) {
        for (Vertex by = -2; by <= 2; ++by) {
          const Vertex area = std::abs(ax * by - ay * bx);
          if (area == 0) continue;
          const Periodic how{.lattice = {{1, 0}, {0, 1}}, .offsets = {{0, 0, ax, ay, bx, by}}};
          CHECK(broken_by_definition({{0, 0}}, {{0, 0, 0}}, how) ==
                std::set{area == 1 ? Rule::kNotClosed : Rule::kOverlap});
        }
      }
    }
  }
}

TEST_CASE("periodic-delaunay: balls are looked at once every point is a vertex") {
  const Periodic how{.lattice = {{1, 0}, {0, 1}},
                     .offsets = {{0, 0, 1, 0, 1, 1}, {0, 0, 0, 1, 1, 1}}};
  const std::vector<Simplex> cells(2, {0, 0, 0});
  CHECK(broken_by_definition({{0, 0}}, cells, how).empty());
  const Point unused = {Rational(1, 2), Rational(1, 3)};
  CHECK(broken_by_definition({{0, 0}, unused}, cells, how) == std::set{Rule::kUnusedPoint});
  const std::vector<Simplex> of_the_second(2, {1, 1, 1});
  CHECK(broken_by_definition({unused, {0, 0}}, of_the_second, how) == std::set{Rule::kUnusedPoint});
}

}  // namespace
}  // namespace circumspect::properties::periodic
